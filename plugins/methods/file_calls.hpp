// File calls are the functions of extensions that read and write files; they need no instance, and
// report errors in a message.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <exception>
#include <new>
#include <string>

#include "methods/mesh_workspace.hpp"
#include "talweg/plugin/talweg_arrays.hpp"

namespace talweg::plugins {

/// `message`, of `size` bytes, may be null.
inline void tell(const char* sentence, char* message, std::uint64_t size) noexcept {
  if (message == nullptr || size == 0) return;
  const std::size_t length = std::min<std::size_t>(std::strlen(sentence), size - 1);
  std::memcpy(message, sentence, length);
  message[length] = 0;
}

/// Runs `body`; an exception becomes a status and a message.
template <class Body>
talweg_status attempt(char* message, std::uint64_t size, Body body) noexcept {
  try {
    tell("", message, size);
    body();
    return TALWEG_OK;
  } catch (const plugin::Failure& failure) {
    tell(failure.what(), message, size);
    return failure.status();
  } catch (const std::bad_alloc&) {
    tell("There is not enough memory.", message, size);
    return TALWEG_OUT_OF_MEMORY;
  } catch (const std::exception& error) {
    tell(error.what(), message, size);
    return status_of(error);
  }
}

[[noreturn]] inline void bad_call(const std::string& sentence) {
  throw plugin::Failure(TALWEG_BAD_USAGE, sentence);
}

}  // namespace talweg::plugins
