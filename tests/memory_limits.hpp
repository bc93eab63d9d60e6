// Sanitizers reserve more addresses than a memory limit allows.
#pragma once

namespace talweg::test {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kMemoryCanBeLimited = false;
#elif defined(__has_feature)
inline constexpr bool kMemoryCanBeLimited =
    !__has_feature(address_sanitizer) && !__has_feature(thread_sanitizer);
#else
inline constexpr bool kMemoryCanBeLimited = true;
#endif

}  // namespace talweg::test
