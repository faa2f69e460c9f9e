#include "physics/tick/solver_settings.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace carom;

namespace {

const std::vector<SolverSettings> samples{
    {.kind = SolverKind::discrete},
    {.kind = SolverKind::substep, .updates = 8, .steps = 1000},
    {.kind = SolverKind::swept, .substeps = 4},
    {.kind = SolverKind::contact, .contact_substeps = 16},
    {.kind = SolverKind::event},
};

}  // namespace

TEST_CASE("every text of the settings reads back") {
    using enum SettingsText;
    for (const SolverSettings& settings : samples)
        for (const SettingsText which : {used, unusual, recorded}) {
            const std::string text = settings_text(settings, which);
            CAPTURE(text);
            CHECK(parse_solver_settings(text) == settings);
        }
}

TEST_CASE("texts of the settings in levels, tables and recordings") {
    using enum SettingsText;
    CHECK(settings_text({.kind = SolverKind::substep}, used) == "substep updates=4 steps=15");
    CHECK(settings_text({.kind = SolverKind::contact}, used) == "contact substeps=4");
    CHECK(settings_text({.kind = SolverKind::event}, used) == "event");
    CHECK(settings_text({.kind = SolverKind::substep}, unusual) == "substep");
    CHECK(settings_text({.kind = SolverKind::substep, .updates = 8, .steps = 3}, unusual) ==
          "substep updates=8 steps=3");
    CHECK(settings_text({.kind = SolverKind::swept, .substeps = 4}, unusual) == "swept substeps=4");
    CHECK(settings_text({.kind = SolverKind::discrete, .substeps = 4}, unusual) == "discrete");
    CHECK(settings_text({.kind = SolverKind::event, .extended = true}, unusual) ==
          "event extended");
    CHECK(settings_text({.kind = SolverKind::event}, recorded) ==
          "event updates=4 steps=15 substeps=1");
    CHECK(settings_text({.kind = SolverKind::contact}, recorded) ==
          "contact updates=4 steps=15 substeps=4");
}

TEST_CASE("an invalid text of settings gives none") {
    for (const char* text : {"", "Swept", "swept substeps", "swept substeps=", "swept substeps=0",
                             "swept substeps=1001", "swept substeps=2x", "swept speed=2",
                             "swept substeps=2 substeps=3", "swept  substeps=2"}) {
        CAPTURE(text);
        CHECK_FALSE(parse_solver_settings(text));
    }
}

TEST_CASE("only counts from 1 to 1000 are in range") {
    CHECK(are_in_range({}));
    CHECK(are_in_range({.kind = SolverKind::event, .steps = 1000}));
    CHECK_FALSE(are_in_range({.kind = SolverKind::event, .steps = 1001}));
    CHECK_FALSE(are_in_range({.kind = SolverKind::contact, .contact_substeps = 0}));
    CHECK(are_in_range({.kind = SolverKind::swept, .contact_substeps = 0}));
}

TEST_CASE("a solver is found by its exact name") {
    CHECK(solver_named("swept") == SolverKind::swept);
    CHECK_FALSE(solver_named("Swept"));
}
