// For systems that cannot load libraries: plugins are linked into the program.
#include <stdexcept>

#include "shared_library.hpp"

namespace talweg::loader {

SharedLibrary::SharedLibrary(const std::string&) {
  throw std::runtime_error("This program cannot load libraries.");
}

SharedLibrary::~SharedLibrary() = default;

void* SharedLibrary::symbol(const char*) const { return handle_; }

}  // namespace talweg::loader
