#include "shared_library.hpp"

#include <mutex>
#include <stdexcept>

#include <dlfcn.h>

#include "library_file.hpp"

namespace talweg::loader {
namespace {

/// dlopen() and dlclose() synchronise threads. The thread sanitizer does not know this for objects
/// that a library creates when it is loaded and destroys when it is unloaded.
std::mutex& loading() {
  static std::mutex mutex;
  return mutex;
}

}  // namespace

SharedLibrary::SharedLibrary(const std::string& path) {
  check_library_file(path);
  const std::scoped_lock lock(loading());
  handle_ = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle_ != nullptr) return;
  const char* why = dlerror();
  throw std::runtime_error(std::string("It cannot be loaded: ") +
                           (why == nullptr ? "unknown reason" : why) + ".");
}

SharedLibrary::~SharedLibrary() {
  if (handle_ == nullptr) return;
  const std::scoped_lock lock(loading());
  dlclose(handle_);
}

void* SharedLibrary::symbol(const char* name) const { return dlsym(handle_, name); }

}  // namespace talweg::loader
