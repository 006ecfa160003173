// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace hardball::platform {

/// The end of a connection, as the system numbers it.
#if defined(_WIN32)
using Socket = std::uintptr_t;
#else
using Socket = int;
#endif

/// To be called before the socket gets a port: no other program gets the same one meanwhile, and one that has
/// just been given up can be had.
void keep_port(Socket socket);

/// Whether something can be read from the socket, or written to it, before so much time has passed.
bool can_read(Socket socket, std::chrono::milliseconds patience);
bool can_write(Socket socket, std::chrono::milliseconds patience);

/// Reads at most `most` bytes, and returns their number: zero at the end, negative if that is impossible.
std::ptrdiff_t receive(Socket socket, char* bytes, std::size_t most);
/// Writes bytes, at least one, and returns their number; negative if that is impossible.
std::ptrdiff_t send(Socket socket, std::string_view bytes);
/// Writes what can be written at once.
void send_at_once(Socket socket, std::string_view bytes);

/// Ends the connection; those who wait for it wake up.
void end_connection(Socket socket);
void close_socket(Socket socket);

}  // namespace hardball::platform
