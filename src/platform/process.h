// SPDX-License-Identifier: BSD-3-Clause
// This process, what it starts and loads, and its machine.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "platform/signals.h"

namespace boxplus {

int process_id();
/// The file of the program that this process runs, or an empty path if it is unknown.
std::filesystem::path program_path();
/// Calls the handler in each child process that this process forks from now on.
void after_fork(void (*handler)());
/// Opens the URL with the user's browser, whose output is dropped, and which blocks only `signals`. Returns
/// false if there is no program that opens URLs.
bool start_browser(const std::string& url, const SignalSet& signals);
/// A function of a library, which stays loaded until the process ends. Returns nullptr, and sets `error`, if
/// the library cannot be loaded or does not have the function.
void* load_function(const std::string& library, const char* name, std::string& error);

/// The name by which other machines may know this one; nullopt if it is unknown.
std::optional<std::string> host_name();
/// Fills up to 256 bytes from the system's source of random numbers. Returns false if there is none.
bool fill_randomly(std::span<unsigned char> bytes);

}  // namespace boxplus
