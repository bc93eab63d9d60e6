// A shared library, loaded as long as its object lives.
#pragma once

#include <string>

namespace talweg::loader {

class SharedLibrary {
 public:
  /// Throws std::runtime_error with one sentence on why the file cannot be loaded: the file is not
  /// a library, is for another kind of machine, is truncated, or needs a library that is missing.
  explicit SharedLibrary(const std::string& path);
  ~SharedLibrary();
  SharedLibrary(SharedLibrary&& other) noexcept : handle_(other.handle_) {
    other.handle_ = nullptr;
  }
  SharedLibrary& operator=(SharedLibrary&&) = delete;

  /// Null if there is no such symbol.
  [[nodiscard]] void* symbol(const char* name) const;

 private:
  void* handle_ = nullptr;
};

}  // namespace talweg::loader
