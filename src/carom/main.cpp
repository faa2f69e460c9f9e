#include <csignal>
#include <exception>
#include <new>
#include <variant>

#include "carom/cli/check.h"
#include "carom/cli/compare.h"
#include "carom/cli/explain.h"
#include "carom/cli/measure.h"
#include "carom/cli/new_level.h"
#include "carom/cli/picture.h"
#include "carom/cli/run.h"
#include "carom/cli/verify.h"
#include "carom/files/print.h"
#include "carom/options/options.h"
#include "carom/play/play.h"

namespace carom {
namespace {

int answer(const UsageAnswer& given) {
    if (given.exit_code == 0) return print_out(given.text) ? 0 : 2;
    print_note(given.text);
    return given.exit_code;
}

struct Perform {
    int operator()(const PlayOptions& options) const { return play(options); }
    int operator()(const RunOptions& options) const { return run(options); }
    int operator()(const MeasureOptions& options) const { return measure(options); }
    int operator()(const CompareOptions& options) const { return compare(options); }
    int operator()(const VerifyOptions& options) const { return verify(options); }
    int operator()(const CheckOptions& options) const { return check(options); }
    int operator()(const PictureOptions& options) const { return picture(options); }
    int operator()(const ExplainOptions& options) const { return explain(options); }
    int operator()(const NewOptions& options) const { return new_level(options); }
    int operator()(const ListOptions& options) const { return list(options); }
    int operator()(const UsageAnswer& given) const { return answer(given); }
};

}  // namespace
}  // namespace carom

int main(int count, char** arguments) {
    // A pipe closed by its reader, and a file that may not grow, are reported by the write that
    // fails.
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    try {
        return std::visit(carom::Perform{}, carom::parse_options(count, arguments));
    } catch (const std::bad_alloc&) {
        carom::print_error("out of memory");
    } catch (const std::exception& fault) {
        carom::print_error(fault.what());
    }
    return 3;
}
