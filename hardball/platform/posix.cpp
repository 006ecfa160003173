// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Linux, macOS and other systems of POSIX.
#include <dlfcn.h>
#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <spawn.h>
#include <stdlib.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <utility>

#include "hardball/platform/files.hpp"
#include "hardball/platform/processors.hpp"
#include "hardball/platform/program.hpp"
#include "hardball/platform/sockets.hpp"

#if defined(__linux__)
#include <sched.h>
#endif
#if defined(__APPLE__)
#include <crt_externs.h>
#include <mach-o/dyld.h>
#endif

namespace hardball::platform {
namespace {

int open_descriptor(const std::filesystem::path& path, Access access) {
  constexpr int kCreate = O_WRONLY | O_CREAT | O_NOFOLLOW | O_CLOEXEC;
  constexpr mode_t kMode = 0666;
  switch (access) {
    case Access::read:
      return open(path.c_str(), O_RDONLY | O_CLOEXEC);
    case Access::write:
      return open(path.c_str(), O_WRONLY | O_CLOEXEC);
    case Access::create:
      return open(path.c_str(), kCreate, kMode);
    case Access::create_new:
      return open(path.c_str(), kCreate | O_EXCL, kMode);
  }
  return -1;
}

// Asks for the names in a directory to be on the disk. Some file systems cannot; then they are when it
// pleases them.
void sync_directory(const std::filesystem::path& directory) {
  const int opened = open(directory.empty() ? "." : directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (opened < 0) return;
  fsync(opened);
  close(opened);
}

// Whether the name still leads to the open file, which the one before may have removed meanwhile.
bool is_named(int file, const std::filesystem::path& path) {
  struct stat open {};
  struct stat named {};
  return fstat(file, &open) == 0 && stat(path.c_str(), &named) == 0 && open.st_ino == named.st_ino;
}

}  // namespace

File::File(const std::filesystem::path& path, Access access) : descriptor_(open_descriptor(path, access)) {}

std::uint64_t File::names() const {
  struct stat status {};
  return fstat(descriptor_, &status) == 0 && S_ISREG(status.st_mode) ? status.st_nlink : 0;
}

std::ptrdiff_t File::read_at(std::uint64_t offset, char* bytes, std::size_t most) const {
  ssize_t count = 0;
  do {
    count = pread(descriptor_, bytes, most, static_cast<off_t>(offset));
  } while (count < 0 && errno == EINTR);
  return count;
}

bool File::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(descriptor_, bytes.data(), bytes.size());
    if (count < 0 && errno != EINTR) return false;
    if (count > 0) bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

bool File::seek(std::uint64_t offset) {
  return lseek(descriptor_, static_cast<off_t>(offset), SEEK_SET) >= 0;
}

bool File::resize(std::uint64_t bytes) {
  return ftruncate(descriptor_, static_cast<off_t>(bytes)) == 0;
}

bool File::sync() {
  return fsync(descriptor_) == 0;
}

bool File::close() {
  return descriptor_ < 0 || ::close(std::exchange(descriptor_, -1)) == 0;
}

bool remove_file(const std::filesystem::path& path) {
  return unlink(path.c_str()) == 0;
}

bool rename_file(const std::filesystem::path& from, const std::filesystem::path& to) {
  if (std::rename(from.c_str(), to.c_str()) != 0) return false;
  sync_directory(to.parent_path());
  return true;
}

std::filesystem::path create_temporary_file(const std::filesystem::path& folder) {
  std::string name = (folder / "hardball-XXXXXX").string();
  const int file = mkstemp(name.data());
  if (file < 0) return {};
  close(file);
  return name;
}

LockFile::LockFile(const std::filesystem::path& path) : path_(path) {
  constexpr mode_t kReadableByAll = 0644;
  int file = -1;
  do {
    if (file >= 0) close(file);
    file = open(path_.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, kReadableByAll);
    if (file < 0) return;
    if (flock(file, LOCK_EX | LOCK_NB) != 0) {
      const int reason = errno;
      close(file);
      errno = reason;
      state_ = reason == EWOULDBLOCK ? State::held_by_another : State::not_locked;
      return;
    }
  } while (!is_named(file, path_));
  file_ = file;
  state_ = State::held;
}

LockFile::~LockFile() {
  if (file_ < 0) return;
  unlink(path_.c_str());
  close(static_cast<int>(file_));
}

std::vector<int> available_processors() {
  std::vector<int> processors;
#if defined(__linux__)
  cpu_set_t available;
  if (sched_getaffinity(0, sizeof available, &available) != 0) return processors;
  for (int processor = 0; processor < CPU_SETSIZE; ++processor) {
    if (CPU_ISSET(static_cast<unsigned>(processor), &available)) processors.push_back(processor);
  }
#endif
  return processors;
}

void run_on([[maybe_unused]] const std::vector<int>& processors) {
#if defined(__linux__)
  cpu_set_t chosen;
  CPU_ZERO(&chosen);
  for (const int processor : processors) CPU_SET(static_cast<unsigned>(processor), &chosen);
  pthread_setaffinity_np(pthread_self(), sizeof chosen, &chosen);
#endif
}

double load_average() {
#if defined(__linux__) || defined(__APPLE__)
  double load = 0;
  if (getloadavg(&load, 1) == 1) return load;
#endif
  return 0;
}

double thread_seconds() {
  timespec time;
  if (clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time) == 0)
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void advise_huge_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) {
#if defined(__linux__)
  static_cast<void>(madvise(memory, bytes, MADV_HUGEPAGE));
#endif
}

char** unicode_arguments(int& /*count*/, char** arguments) {
  return arguments;
}

void secure_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    // The lowest number that is free; nothing can be written to it.
    if (fcntl(stream, F_GETFD) < 0) static_cast<void>(open("/dev/null", O_RDONLY));
  }
  std::signal(SIGPIPE, SIG_IGN);
}

bool shows_messages() {
  return isatty(STDERR_FILENO) == 1;
}

namespace {

std::atomic<bool> signal_came = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a handler of signals sets it");

extern "C" void note_signal(int) {
  signal_came = true;
}

}  // namespace

void catch_interruption() {
  struct sigaction action {};
  action.sa_handler = note_signal;
  action.sa_flags = static_cast<int>(SA_RESTART | SA_RESETHAND);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  std::signal(SIGXFSZ, SIG_IGN);
}

bool was_interrupted() {
  return signal_came;
}

std::uint64_t peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
#if defined(__APPLE__)
  constexpr std::uint64_t kBytesPerUnit = 1;
#else
  constexpr std::uint64_t kBytesPerUnit = 1024;
#endif
  return static_cast<std::uint64_t>(usage.ru_maxrss) * kBytesPerUnit;
}

std::uint64_t physical_memory() {
  const long pages = sysconf(_SC_PHYS_PAGES);
  const long bytes = sysconf(_SC_PAGESIZE);
  return pages > 0 && bytes > 0 ? static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(bytes) : 0;
}

std::filesystem::path program_file() {
  std::error_code error;
#if defined(__APPLE__)
  char name[4096];
  std::uint32_t bytes = sizeof name;
  if (_NSGetExecutablePath(name, &bytes) != 0) return {};
  const std::filesystem::path program = std::filesystem::canonical(name, error);
#else
  const std::filesystem::path program = std::filesystem::canonical("/proc/self/exe", error);
#endif
  return error ? std::filesystem::path() : program;
}

bool has_display() {
#if defined(__APPLE__)
  return true;
#else
  return std::getenv("DISPLAY") || std::getenv("WAYLAND_DISPLAY");
#endif
}

namespace {

// Starts a program in a group of its own, without standard streams; zero if that is impossible.
pid_t start_program(const std::string& program, const std::vector<std::string>& arguments) {
#if defined(__APPLE__)
  char** const environment = *_NSGetEnviron();
#else
  char** const environment = environ;
#endif
  std::vector<std::string> words{program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    posix_spawn_file_actions_addopen(&actions, stream, "/dev/null", O_RDWR, 0);
  }
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  posix_spawnattr_setpgroup(&attributes, 0);
  pid_t process = 0;
  if (posix_spawnp(&process, program.c_str(), &actions, &attributes, pointers.data(), environment) != 0) {
    process = 0;
  }
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  return process;
}

}  // namespace

void open_browser(const std::string& url) {
#if defined(__APPLE__)
  start_program("open", {url});
#else
  start_program("xdg-open", {url});
#endif
}

std::filesystem::path find_program(const std::vector<std::string_view>& names) {
  const char* const folders = std::getenv("PATH");
  if (!folders) return {};
  for (const std::string_view name : names) {
    std::string_view rest = folders;
    for (bool is_last = false; !is_last;) {
      const std::size_t end = rest.find(':');
      const std::filesystem::path file = std::filesystem::path(rest.substr(0, end)) / name;
      if (access(file.c_str(), X_OK) == 0) return file;
      is_last = end == std::string_view::npos;
      if (!is_last) rest.remove_prefix(end + 1);
    }
  }
  return {};
}

ChildProgram::ChildProgram(const std::filesystem::path& program, const std::vector<std::string>& arguments)
    : process_(start_program(program.string(), arguments)), group_(process_), has_started_(process_ != 0) {}

ChildProgram::~ChildProgram() {
  if (group_ == 0) return;
  constexpr int kPatience = 100;
  const timespec moment{0, 20'000'000};
  const auto group = static_cast<pid_t>(group_);
  kill(-group, SIGTERM);
  for (int k = 0; k < kPatience && is_running(); ++k) nanosleep(&moment, nullptr);
  kill(-group, SIGKILL);
  if (process_ != 0) waitpid(static_cast<pid_t>(process_), nullptr, 0);
}

bool ChildProgram::is_running() {
  if (process_ == 0) return false;
  if (waitpid(static_cast<pid_t>(process_), nullptr, WNOHANG) != 0) process_ = 0;
  return process_ != 0;
}

bool is_superuser() {
  return geteuid() == 0;
}

void* symbol_of_library(const std::filesystem::path& library, const char* name, std::string& problem) {
  // For all of the program: Open MPI loads plug-ins of its own, which look for its functions there.
  void* const loaded = dlopen(library.c_str(), RTLD_NOW | RTLD_GLOBAL);
  void* const symbol = loaded ? dlsym(loaded, name) : nullptr;
  if (!symbol) problem = dlerror();
  return symbol;
}

namespace {

#if defined(MSG_NOSIGNAL)
constexpr int kNoSignal = MSG_NOSIGNAL;
#else
constexpr int kNoSignal = 0;  // the program ignores the signal
#endif

bool is_ready(Socket socket, short event, std::chrono::milliseconds patience) {
  pollfd asked{socket, event, 0};
  return patience.count() > 0 && poll(&asked, 1, static_cast<int>(patience.count())) > 0;
}

}  // namespace

void keep_port(Socket socket) {
  const int yes = 1;
  setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
}

bool can_read(Socket socket, std::chrono::milliseconds patience) {
  return is_ready(socket, POLLIN, patience);
}

bool can_write(Socket socket, std::chrono::milliseconds patience) {
  return is_ready(socket, POLLOUT, patience);
}

std::ptrdiff_t receive(Socket socket, char* bytes, std::size_t most) {
  return recv(socket, bytes, most, 0);
}

std::ptrdiff_t send(Socket socket, std::string_view bytes) {
  return ::send(socket, bytes.data(), bytes.size(), kNoSignal);
}

void send_at_once(Socket socket, std::string_view bytes) {
  static_cast<void>(::send(socket, bytes.data(), bytes.size(), kNoSignal | MSG_DONTWAIT));
}

void end_connection(Socket socket) {
  shutdown(socket, SHUT_RDWR);
}

void close_socket(Socket socket) {
  close(socket);
}

}  // namespace hardball::platform
