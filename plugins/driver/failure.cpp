#include "failure.hpp"

#include <exception>
#include <new>

#include "commands.hpp"
#include "output_file.hpp"
#include "talweg/intrinsic/error.hpp"
#include "talweg/intrinsic/progress.hpp"

namespace talweg::driver {
namespace {

int exit_code_of(ErrorCode code) {
  switch (code) {
    case ErrorCode::kBadUsage:
      return kBadUsage;
    case ErrorCode::kBadMesh:
    case ErrorCode::kBadCurve:
    case ErrorCode::kBadFile:
      return kBadInput;
    case ErrorCode::kNumerical:
    case ErrorCode::kOutOfMemory:
      return kInternal;
  }
  return kInternal;
}

}  // namespace

Failure current_failure() {
  try {
    throw;
  } catch (const Error& error) {
    const char* hint =
        error.code() == ErrorCode::kBadMesh
            ? " (talweg info lists the defects and says whether --repair can mend them)"
            : "";
    return {exit_code_of(error.code()), error.what() + std::string(hint)};
  } catch (const WaitCancelled& waiting) {
    return {kCancelled, "cancelled while " + waiting.path +
                            " waited for its reader; outputs named before it are written."};
  } catch (const Cancelled&) {
    return {kCancelled, "cancelled; nothing was written."};
  } catch (const std::bad_alloc&) {
    return {kInternal, "There is not enough memory."};
  } catch (const std::exception& error) {
    return {kInternal, std::string("Internal error: ") + error.what()};
  }
}

}  // namespace talweg::driver
