#include "carom/files/high_scores.h"
#include "fuzz/fuzzer.h"

// High scores: a file is refused, or a score that is added to it is read again.

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace carom;
    const std::string_view text = fuzz::text_of(bytes, size);
    HighScoresText read = read_high_scores(text, "table", 5, "high-scores");
    if (read.problem) {
        fuzz::check(!read.problem->empty());
        return 0;
    }
    fuzz::check(read.scores.lines.size() <= 5);
    read.scores.add({"ABC", 1'000'000'000'000});
    const std::string changed = with_high_scores(text, "table", read.scores);
    const HighScoresText again = read_high_scores(changed, "table", 5, "high-scores");
    fuzz::check(!again.problem && again.scores.lines == read.scores.lines);
    return 0;
}
