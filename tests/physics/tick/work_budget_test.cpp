#include "physics/tick/work_budget.h"

#include <doctest/doctest.h>

using namespace carom;

namespace {

constexpr WorkBudget::Allowance allowance{.per_ball = 1000, .least_balls = 10};

// The work that a trial does before time stands still for all of its balls, one unit at a time.
std::uint64_t work_of_trial(WorkBudget& budget, std::size_t balls, bool is_repeated) {
    budget.begin(balls, allowance, is_repeated);
    std::uint64_t work = 0;
    for (std::uint32_t ball = 0; ball < balls;) {
        ++work;
        if (budget.spend(1) && budget.charge(ball, 1)) ++ball;
    }
    return work;
}

}  // namespace

TEST_CASE("work budget: a tick takes at most twice its budget") {
    WorkBudget budget;
    for (const std::size_t balls : {1u, 5u, 10u, 100u}) {
        const std::uint64_t limit = 1000 * (balls < 10 ? 10 : balls);
        const std::uint64_t work = work_of_trial(budget, balls, false);
        CHECK(work > limit);
        CHECK(work <= 2 * limit + balls);
        CHECK(work_of_trial(budget, balls, false) == work);
    }
}

// Regression: each trial of hands and movers had a budget of its own, and a tick up to nine of
// them.
TEST_CASE("work budget: all trials of a tick share one budget") {
    WorkBudget budget;
    const std::size_t balls = 20;
    const std::uint64_t limit = 1000 * balls;
    std::uint64_t work = work_of_trial(budget, balls, false);
    for (int trial = 1; trial < 20; ++trial)
        work += work_of_trial(budget, balls, true);
    CHECK(work <= 3 * limit + 20 * balls);
    // A trial that costs little takes little from the next.
    budget.begin(balls, allowance, false);
    CHECK(!budget.spend(100));
    budget.begin(balls, allowance, true);
    CHECK(!budget.spend(limit - 100));
    CHECK(budget.spend(1));
}
