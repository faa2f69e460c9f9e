#include "fuzz/fuzzer.h"
#include "terminal/input/input_decoder.h"

// What a terminal sends: however the bytes are split, the same events come of it.

namespace {

using namespace carom;

void add(DecodedInput& all, DecodedInput more) {
    all.events.insert(all.events.end(), more.events.begin(), more.events.end());
    all.answers.insert(all.answers.end(), more.answers.begin(), more.answers.end());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    const std::string_view text = fuzz::text_of(bytes, size);
    for (const bool utf8 : {true, false}) {
        InputDecoder whole(utf8);
        DecodedInput at_once = whole.feed(text);
        add(at_once, whole.flush());
        InputDecoder split(utf8);
        DecodedInput one_by_one;
        for (const char byte : text)
            add(one_by_one, split.feed({&byte, 1}));
        add(one_by_one, split.flush());
        fuzz::check(at_once.events.size() == one_by_one.events.size());
        fuzz::check(at_once.answers.size() == one_by_one.answers.size());
        fuzz::check(at_once.events.size() <= text.size() + 1);
        for (std::size_t i = 0; i < at_once.events.size(); ++i)
            fuzz::check(at_once.events[i].key == one_by_one.events[i].key &&
                        at_once.events[i].kind == one_by_one.events[i].kind);
        fuzz::check(whole.pending() == InputDecoder::Pending::nothing);
    }
    return 0;
}
