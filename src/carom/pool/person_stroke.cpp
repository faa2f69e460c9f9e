#include "carom/pool/person_stroke.h"

namespace carom {

bool PersonStroke::pass(double seconds) {
    now_ += seconds;
    if (!meter_) return true;
    meter_->pass(seconds);
    if (!meter_->is_over()) return true;
    meter_.reset();
    return false;
}

bool PersonStroke::repeats(char32_t key, double after) {
    return keys_.take(key, time(after)) == KeyRepeat::Meaning::repeat && keys_.times();
}

std::string_view hand_text(int level) {
    constexpr std::string_view texts[] = {"a shaky hand", "a fair hand", "a good hand",
                                          "a sure hand"};
    return texts[level - least_hand];
}

}  // namespace carom
