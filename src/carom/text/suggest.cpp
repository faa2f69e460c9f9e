#include "carom/text/suggest.h"

#include "level/text/spelling.h"

namespace carom {

std::string suggestion(std::string_view typed, const std::vector<std::string_view>& candidates) {
    const std::string question = did_you_mean(typed, candidates, "");
    return question.empty() ? question : "; " + question;
}

}  // namespace carom
