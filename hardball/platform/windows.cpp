// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Windows, from version 10 on. Paths are wide; narrow text is UTF-8.
#define NOMINMAX
#define WIN32_LEAN_AND_MEAN
#define PSAPI_VERSION 2
#include <winsock2.h>
// After it:
#include <windows.h>
//
#include <fcntl.h>
#include <io.h>
#include <psapi.h>
#include <shellapi.h>
#include <sys/stat.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <clocale>
#include <cstdio>
#include <stdexcept>
#include <utility>

#include "hardball/platform/files.hpp"
#include "hardball/platform/processors.hpp"
#include "hardball/platform/program.hpp"
#include "hardball/platform/sockets.hpp"

namespace hardball::platform {
namespace {

constexpr int kStandardInput = 0;
constexpr int kStandardOutput = 1;
constexpr int kStandardError = 2;

int open_descriptor(const std::filesystem::path& path, Access access) {
  constexpr int kCreate = _O_WRONLY | _O_CREAT | _O_BINARY | _O_NOINHERIT;
  constexpr int kMode = _S_IREAD | _S_IWRITE;
  switch (access) {
    case Access::read:
      return _wopen(path.c_str(), _O_RDONLY | _O_BINARY | _O_NOINHERIT);
    case Access::write:
      return _wopen(path.c_str(), _O_WRONLY | _O_BINARY | _O_NOINHERIT);
    case Access::create:
      return _wopen(path.c_str(), kCreate, kMode);
    case Access::create_new:
      return _wopen(path.c_str(), kCreate | _O_EXCL, kMode);
  }
  return -1;
}

HANDLE handle_of(int descriptor) {
  return reinterpret_cast<HANDLE>(_get_osfhandle(descriptor));
}

// The number of errno for an error of the system.
int errno_of(DWORD error) {
  switch (error) {
    case ERROR_FILE_NOT_FOUND:
    case ERROR_PATH_NOT_FOUND:
    case ERROR_INVALID_NAME:
      return ENOENT;
    case ERROR_ACCESS_DENIED:
    case ERROR_SHARING_VIOLATION:
    case ERROR_LOCK_VIOLATION:
    case ERROR_WRITE_PROTECT:
      return EACCES;
    case ERROR_FILE_EXISTS:
    case ERROR_ALREADY_EXISTS:
      return EEXIST;
    case ERROR_DISK_FULL:
    case ERROR_HANDLE_DISK_FULL:
      return ENOSPC;
    case ERROR_INVALID_FUNCTION:
    case ERROR_INVALID_PARAMETER:
      return EINVAL;
    default:
      return EIO;
  }
}

// False, with errno, if a function of the system has failed.
bool checked(bool is_done) {
  if (!is_done) errno = errno_of(GetLastError());
  return is_done;
}

std::string narrow(const wchar_t* text) {
  std::string bytes;
  const int length = WideCharToMultiByte(CP_UTF8, 0, text, -1, nullptr, 0, nullptr, nullptr);
  if (length <= 1) return bytes;
  bytes.resize(static_cast<std::size_t>(length));
  WideCharToMultiByte(CP_UTF8, 0, text, -1, bytes.data(), length, nullptr, nullptr);
  bytes.pop_back();
  return bytes;
}

}  // namespace

File::File(const std::filesystem::path& path, Access access) : descriptor_(open_descriptor(path, access)) {}

std::uint64_t File::names() const {
  BY_HANDLE_FILE_INFORMATION information{};
  const HANDLE handle = handle_of(descriptor_);
  if (GetFileType(handle) != FILE_TYPE_DISK || !GetFileInformationByHandle(handle, &information)) return 0;
  return information.nNumberOfLinks;
}

std::ptrdiff_t File::read_at(std::uint64_t offset, char* bytes, std::size_t most) const {
  constexpr std::size_t kMost = std::size_t{1} << 30;
  OVERLAPPED place{};
  place.Offset = static_cast<DWORD>(offset);
  place.OffsetHigh = static_cast<DWORD>(offset >> 32);
  DWORD count = 0;
  if (ReadFile(handle_of(descriptor_), bytes, static_cast<DWORD>(std::min(most, kMost)), &count, &place))
    return static_cast<std::ptrdiff_t>(count);
  if (GetLastError() == ERROR_HANDLE_EOF) return 0;
  checked(false);
  return -1;
}

bool File::write(std::string_view bytes) {
  constexpr std::size_t kMost = std::size_t{1} << 30;
  while (!bytes.empty()) {
    const int count = _write(descriptor_, bytes.data(), static_cast<unsigned>(std::min(bytes.size(), kMost)));
    if (count < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

bool File::seek(std::uint64_t offset) {
  return _lseeki64(descriptor_, static_cast<std::int64_t>(offset), SEEK_SET) >= 0;
}

bool File::resize(std::uint64_t bytes) {
  FILE_END_OF_FILE_INFO end{};
  end.EndOfFile.QuadPart = static_cast<LONGLONG>(bytes);
  return checked(SetFileInformationByHandle(handle_of(descriptor_), FileEndOfFileInfo, &end, sizeof end));
}

bool File::sync() {
  return checked(FlushFileBuffers(handle_of(descriptor_)));
}

bool File::close() {
  return descriptor_ < 0 || _close(std::exchange(descriptor_, -1)) == 0;
}

bool remove_file(const std::filesystem::path& path) {
  return checked(DeleteFileW(path.c_str()));
}

bool rename_file(const std::filesystem::path& from, const std::filesystem::path& to) {
  // Those who read the file for a moment, such as virus scanners, keep it from being replaced.
  constexpr int kTries = 50;
  constexpr DWORD kPause = 20;  // milliseconds
  constexpr DWORD kHow = MOVEFILE_REPLACE_EXISTING | MOVEFILE_WRITE_THROUGH;
  for (int attempt = 1;; ++attempt) {
    if (MoveFileExW(from.c_str(), to.c_str(), kHow)) return true;
    const DWORD error = GetLastError();
    const bool is_busy = error == ERROR_SHARING_VIOLATION || error == ERROR_ACCESS_DENIED;
    if (!is_busy || attempt == kTries || GetFileAttributesW(to.c_str()) & FILE_ATTRIBUTE_DIRECTORY) {
      errno = errno_of(error);
      return false;
    }
    Sleep(kPause);
  }
}

std::filesystem::path create_temporary_file(const std::filesystem::path& folder) {
  wchar_t name[MAX_PATH + 1];
  return checked(GetTempFileNameW(folder.c_str(), L"hb", 0, name) != 0) ? name : std::filesystem::path();
}

// Nobody else can open the file, and the system removes it when it is closed.
LockFile::LockFile(const std::filesystem::path& path) : path_(path) {
  const HANDLE file = CreateFileW(path_.c_str(), GENERIC_READ | GENERIC_WRITE | DELETE, 0, nullptr,
                                  OPEN_ALWAYS, FILE_ATTRIBUTE_NORMAL | FILE_FLAG_DELETE_ON_CLOSE, nullptr);
  if (file == INVALID_HANDLE_VALUE) {
    const bool is_held = GetLastError() == ERROR_SHARING_VIOLATION;
    checked(false);
    state_ = is_held ? State::held_by_another : State::not_created;
    return;
  }
  file_ = reinterpret_cast<std::intptr_t>(file);
  state_ = State::held;
}

LockFile::~LockFile() {
  if (file_ != -1) CloseHandle(reinterpret_cast<HANDLE>(file_));
}

std::vector<int> available_processors() {
  return {};
}

void run_on(const std::vector<int>& /*processors*/) {}

double load_average() {
  return 0;
}

double thread_seconds() {
  FILETIME unused;
  FILETIME system;
  FILETIME user;
  if (!GetThreadTimes(GetCurrentThread(), &unused, &unused, &system, &user))
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  const auto seconds = [](const FILETIME& time) {
    constexpr double kUnit = 1e-7;
    return kUnit * (0x1p32 * time.dwHighDateTime + time.dwLowDateTime);
  };
  return seconds(system) + seconds(user);
}

void advise_huge_pages(void* /*memory*/, std::size_t /*bytes*/) {}

char** unicode_arguments(int& count, char** arguments) {
  static std::vector<std::string> texts;
  static std::vector<char*> pointers;
  int given = 0;
  wchar_t** const wide = CommandLineToArgvW(GetCommandLineW(), &given);
  if (!wide) return arguments;
  for (int k = 0; k < given; ++k) texts.push_back(narrow(wide[k]));
  LocalFree(wide);
  // So that paths are made of narrow text as UTF-8. The C library of Windows 10 can do that, the older one
  // cannot.
  const bool has_unicode = std::setlocale(LC_CTYPE, ".UTF-8") != nullptr;
  const auto is_foreign = [](char c) { return static_cast<unsigned char>(c) >= 0x80; };
  for (const std::string& text : texts) {
    if (has_unicode || std::none_of(text.begin(), text.end(), is_foreign)) continue;
    throw std::runtime_error("'" + text +
                             "' has letters beyond ASCII, which this build of the program cannot use");
  }
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  count = given;
  return pointers.data();
}

void secure_streams() {
  SetConsoleOutputCP(CP_UTF8);
  for (const int stream : {kStandardInput, kStandardOutput, kStandardError}) {
    // The lowest number that is free; nothing can be written to it.
    if (_get_osfhandle(stream) < 0) static_cast<void>(_wopen(L"NUL", _O_RDONLY));
  }
  _setmode(kStandardOutput, _O_BINARY);
  _setmode(kStandardError, _O_BINARY);
}

bool shows_messages() {
  return _isatty(kStandardError) != 0;
}

namespace {

std::atomic<bool> request_came = false;

// Called in a thread of its own.
BOOL WINAPI note_request(DWORD kind) {
  if (request_came.exchange(true)) return FALSE;  // as without this function: the program ends
  // When this function returns, the system ends the program; until then it has some seconds.
  if (kind != CTRL_C_EVENT && kind != CTRL_BREAK_EVENT) Sleep(INFINITE);
  return TRUE;
}

}  // namespace

void catch_interruption() {
  SetConsoleCtrlHandler(note_request, TRUE);
}

bool was_interrupted() {
  return request_came;
}

std::uint64_t peak_memory() {
  PROCESS_MEMORY_COUNTERS counters{};
  return GetProcessMemoryInfo(GetCurrentProcess(), &counters, sizeof counters) ? counters.PeakWorkingSetSize
                                                                               : 0;
}

std::uint64_t physical_memory() {
  MEMORYSTATUSEX memory{};
  memory.dwLength = sizeof memory;
  return GlobalMemoryStatusEx(&memory) ? memory.ullTotalPhys : 0;
}

std::filesystem::path program_file() {
  std::wstring name(1 << 15, L'\0');
  const DWORD length = GetModuleFileNameW(nullptr, name.data(), static_cast<DWORD>(name.size()));
  name.resize(length < name.size() ? length : 0);
  return name;
}

bool has_display() {
  return true;
}

void open_browser(const std::string& url) {
  ShellExecuteW(nullptr, L"open", std::wstring(url.begin(), url.end()).c_str(), nullptr, nullptr,
                SW_SHOWNORMAL);
}

std::filesystem::path find_program(const std::vector<std::string_view>& names) {
  for (const std::string_view name : names) {
    std::wstring file(1 << 15, L'\0');
    const std::wstring wanted = std::filesystem::path(name).wstring();
    const DWORD length =
        SearchPathW(nullptr, wanted.c_str(), L".exe", static_cast<DWORD>(file.size()), file.data(), nullptr);
    file.resize(length < file.size() ? length : 0);
    if (!file.empty()) return file;
  }
  return {};
}

ChildProgram::ChildProgram(const std::filesystem::path& program, const std::vector<std::string>& arguments) {
  // None of the arguments ends with a backslash or has quotation marks.
  std::wstring line = L"\"" + program.wstring() + L"\"";
  for (const std::string& argument : arguments)
    line += L" \"" + std::filesystem::path(argument).wstring() + L"\"";
  const HANDLE job = CreateJobObjectW(nullptr, nullptr);
  JOBOBJECT_EXTENDED_LIMIT_INFORMATION limits{};
  limits.BasicLimitInformation.LimitFlags = JOB_OBJECT_LIMIT_KILL_ON_JOB_CLOSE;
  SetInformationJobObject(job, JobObjectExtendedLimitInformation, &limits, sizeof limits);
  STARTUPINFOW start{};
  start.cb = sizeof start;
  PROCESS_INFORMATION process{};
  constexpr DWORD kFlags = CREATE_NO_WINDOW | CREATE_SUSPENDED;
  if (CreateProcessW(nullptr, line.data(), nullptr, nullptr, FALSE, kFlags, nullptr, nullptr, &start,
                     &process)) {
    AssignProcessToJobObject(job, process.hProcess);
    ResumeThread(process.hThread);
    CloseHandle(process.hThread);
    process_ = reinterpret_cast<std::intptr_t>(process.hProcess);
    has_started_ = true;
  }
  group_ = reinterpret_cast<std::intptr_t>(job);
}

ChildProgram::~ChildProgram() {
  if (group_ != 0) CloseHandle(reinterpret_cast<HANDLE>(group_));
  if (process_ != 0) CloseHandle(reinterpret_cast<HANDLE>(process_));
}

bool ChildProgram::is_running() {
  return process_ != 0 && WaitForSingleObject(reinterpret_cast<HANDLE>(process_), 0) == WAIT_TIMEOUT;
}

bool is_superuser() {
  return false;
}

void* symbol_of_library(const std::filesystem::path& library, const char* name, std::string& problem) {
  const HMODULE loaded = LoadLibraryW(library.c_str());
  const FARPROC symbol = loaded ? GetProcAddress(loaded, name) : nullptr;
  if (!symbol) problem = "error " + std::to_string(GetLastError()) + " of the system";
  return reinterpret_cast<void*>(symbol);
}

namespace {

bool is_ready(Socket socket, short event, std::chrono::milliseconds patience) {
  WSAPOLLFD asked{socket, event, 0};
  return patience.count() > 0 && WSAPoll(&asked, 1, static_cast<int>(patience.count())) > 0;
}

}  // namespace

void keep_port(Socket socket) {
  const int yes = 1;
  setsockopt(socket, SOL_SOCKET, SO_EXCLUSIVEADDRUSE, reinterpret_cast<const char*>(&yes), sizeof yes);
}

bool can_read(Socket socket, std::chrono::milliseconds patience) {
  return is_ready(socket, POLLRDNORM, patience);
}

bool can_write(Socket socket, std::chrono::milliseconds patience) {
  return is_ready(socket, POLLWRNORM, patience);
}

std::ptrdiff_t receive(Socket socket, char* bytes, std::size_t most) {
  constexpr std::size_t kMost = std::size_t{1} << 30;
  return recv(socket, bytes, static_cast<int>(std::min(most, kMost)), 0);
}

std::ptrdiff_t send(Socket socket, std::string_view bytes) {
  constexpr std::size_t kMost = std::size_t{1} << 30;
  return ::send(socket, bytes.data(), static_cast<int>(std::min(bytes.size(), kMost)), 0);
}

void send_at_once(Socket socket, std::string_view bytes) {
  if (can_write(socket, std::chrono::milliseconds(1))) send(socket, bytes);
}

void end_connection(Socket socket) {
  shutdown(socket, SD_BOTH);
}

void close_socket(Socket socket) {
  closesocket(socket);
}

}  // namespace hardball::platform
