// An error says why a call failed, in a sentence that can be shown to the user.
#pragma once

#include <stdexcept>
#include <string>

namespace talweg {

enum class ErrorCode {
  kBadUsage,     ///< an option or argument out of its range
  kBadMesh,      ///< the mesh is not a surface that the library can use
  kBadCurve,     ///< the curve does not lie on the mesh as required
  kBadFile,      ///< a file cannot be opened, read, parsed or written
  kNumerical,    ///< a factorization or solve failed
  kOutOfMemory,  ///< memory ran out
};

/// Thrown when the caller's input cannot be used, a factorization or solve fails, or memory runs
/// out. The message is one sentence that says what is wrong and where (vertex 4711, line 12), and
/// can be shown to a user unchanged.
class Error : public std::runtime_error {
 public:
  Error(ErrorCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
  [[nodiscard]] ErrorCode code() const { return code_; }  ///< for decisions; what() is for display

 private:
  ErrorCode code_;
};

}  // namespace talweg
