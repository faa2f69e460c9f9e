#pragma once

namespace carom::test {

/// Whether this build has the address sanitizer, which slows down simulations about eightfold.
/// Tests that repeat one check over many scenes or shots then try fewer: the release build tries
/// all, and the fewer reach the same code.
#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool has_sanitizers = true;
#elif defined(__has_feature)
inline constexpr bool has_sanitizers = __has_feature(address_sanitizer);
#else
inline constexpr bool has_sanitizers = false;
#endif

}  // namespace carom::test
