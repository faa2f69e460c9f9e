#include "carom/play/preferences.h"
#include "fuzz/fuzzer.h"

// Preferences: every mistake is a message, and a setting that is written is read.

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace carom;
    const std::string_view text = fuzz::text_of(bytes, size);
    for (const std::string& problem : read_preferences(text, "preferences").problems)
        fuzz::check(!problem.empty());
    const std::string changed = with_setting(text, "trails", "on");
    fuzz::check(read_preferences(changed, "preferences").preferences.trails);
    return 0;
}
