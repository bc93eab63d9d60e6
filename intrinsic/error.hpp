// An error is what bad input raises.
#pragma once

#include <stdexcept>
#include <string>

namespace talweg {

enum class ErrorCode {
  kBadUsage,     ///< an option or argument out of its range
  kBadMesh,      ///< the mesh is not a surface that can be worked on
  kBadCurve,     ///< the curve does not lie on the mesh, or not properly
  kBadFile,      ///< a file cannot be opened, read, parsed or written
  kNumerical,    ///< a factorization or solve failed
  kOutOfMemory,  ///< memory ran out
};

/// What the caller gave cannot be used. The message is one sentence that says what is wrong and
/// where (vertex 4711, line 12), fit to be shown to a user as it is.
class Error : public std::runtime_error {
 public:
  Error(ErrorCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
  [[nodiscard]] ErrorCode code() const { return code_; }  ///< to act on; what() is to show

 private:
  ErrorCode code_;
};

}  // namespace talweg
