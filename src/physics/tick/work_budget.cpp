#include "physics/tick/work_budget.h"

namespace carom {

bool WorkBudget::charge(std::uint32_t ball, std::uint64_t work) {
    if (charged_.empty()) charged_.assign(balls_, 0);
    charged_[ball] += work;
    return charged_[ball] > share_;
}

}  // namespace carom
