#include "carom/pool/person_stroke.h"

#include <fmt/format.h>

#include <cmath>

namespace carom {

bool PersonStroke::pass(double seconds) {
    now_ += seconds;
    if (!meter_) return true;
    meter_->pass(seconds);
    if (!meter_->is_over()) return true;
    meter_.reset();
    ran_out_ = now_;
    return false;
}

bool PersonStroke::has_just_run_out() const {
    constexpr double reaction = 1.0;  // s
    return ran_out_ && now_ - *ran_out_ < reaction;
}

std::string PersonStroke::last_text(const Look& look) const {
    if (!last_) return "";
    const double degrees = last_->miss * most_miss(level_);
    constexpr double least = 0.005;  // of what two decimals show
    const std::string off =
        std::abs(degrees) < least
            ? "straight"
            : fmt::format("{:.2f}{} {}", std::abs(degrees), look.utf8 ? "°" : " deg",
                          degrees > 0.0 ? "left" : "right");
    return fmt::format("stroke {}, {:.2f} m/s", off, last_->speed);
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
