#include "lab/run/choice.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <vector>

using namespace carom;

TEST_CASE("the common rate is the greatest that divides all") {
    struct Row {
        std::vector<double> rates;
        double common;
    };
    const Row rows[] = {
        {{120}, 120},         {{30, 60, 120, 480}, 30}, {{100, 120}, 20},
        {{33.3, 99.9}, 33.3}, {{0.5, 0.75}, 0.25},      {{1e6, 60}, 20},
    };
    for (const Row& row : rows) {
        const double common = common_rate(row.rates);
        CHECK(common == doctest::Approx(row.common).epsilon(1e-12));
        for (const double rate : row.rates)
            CHECK(static_cast<double>(ticks_each(rate, common)) * common ==
                  doctest::Approx(rate).epsilon(1e-8));
    }
}

TEST_CASE("the choices: each solver at each rate, no duplicates, the level's own first") {
    Scene scene;
    scene.world.edit_definition().rate = 120;
    scene.solver = SolverSettings{.kind = SolverKind::substep, .updates = 7};
    const std::array kinds{SolverKind::discrete, SolverKind::substep, SolverKind::swept};
    const std::vector<Choice> choices = choices_for(scene, kinds, usual_rates(120));
    CHECK(choices.front() == Choice{*scene.solver, 120});
    for (const SolverKind kind : kinds) {
        for (const double rate : {30.0, 60.0, 120.0, 240.0, 480.0})
            CHECK(std::ranges::count(choices, Choice{{.kind = kind}, rate}) == 1);
    }
    CHECK(std::ranges::count(choices, Choice{{.kind = SolverKind::swept, .substeps = 4}, 120}) ==
          1);
    for (const Choice& choice : choices)
        CHECK(std::ranges::count(choices, choice) == 1);

    // A solver that ignores the cloth cannot be measured against anything.
    scene.world.edit_definition().model.cloth = Cloth{};
    for (const Choice& choice : choices_for(scene, solvers_available(), usual_rates(120)))
        CHECK(choice.solver.kind != SolverKind::contact);
    scene.world.edit_definition().model.cloth.reset();

    const std::array one{SolverKind::discrete};
    for (const Choice& choice : choices_for(scene, one, usual_rates(120)))
        CHECK(choice.solver.kind == SolverKind::discrete);
}

TEST_CASE("the reference and its check are available solvers, and differ") {
    const Reference reference = reference_settings(120);
    for (const Choice& choice : {reference.truth, reference.check})
        CHECK(std::ranges::count(solvers_available(), choice.solver.kind) == 1);
    CHECK_FALSE(reference.truth == reference.check);
}
