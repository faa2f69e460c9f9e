#include "instruction_count.h"

#include <fmt/format.h>
#include <valgrind/callgrind.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace carom::bench {

std::uint64_t InstructionCounter::count(const std::function<void()>& work) {
    CALLGRIND_START_INSTRUMENTATION;
    CALLGRIND_ZERO_STATS;
    work();
    CALLGRIND_DUMP_STATS;
    CALLGRIND_STOP_INSTRUMENTATION;
    const std::string path = fmt::format("{}.{}", dumps_, ++dump_);
    std::ifstream file(path);
    for (std::string word; file >> word;) {
        std::uint64_t instructions = 0;
        if ((word != "summary:" && word != "totals:") || !(file >> instructions)) continue;
        std::filesystem::remove(path);
        return instructions;
    }
    fmt::print(stderr, "error: this does not run under callgrind: see scripts/instructions\n");
    std::exit(2);
}

}  // namespace carom::bench
