#include "lab/plot.h"

#include <doctest/doctest.h>

#include <limits>
#include <vector>

using namespace carom;

TEST_CASE("a plot shows its decades, its points and its front") {
    const std::vector<PlotPoint> points{
        {1e-2, 1e-0, 'A', true}, {1e-1, 1e-1, 'b', false}, {1e0, 1e-4, 'C', true}};
    const std::string plot =
        log_log_plot(points, {.columns = 9, .rows = 5, .x_name = "cost", .y_name = "error"});
    CHECK(plot ==
          "        error\n"
          "    1e0 + A........\n"
          "   1e-1 +     b   .\n"
          "   1e-2 +         .\n"
          "   1e-3 +         .\n"
          "   1e-4 +         C\n"
          "        +-+---+---+\n"
          "          1e-2    1e0\n"
          "          cost\n");
}

TEST_CASE("an error of zero is drawn on a separate line") {
    const std::string plot =
        log_log_plot(std::vector<PlotPoint>{{1, 0, 'Z', true}, {1, 1e-3, 'x', false}},
                     {.columns = 8, .rows = 4, .x_name = "", .y_name = ""});
    CHECK(plot.find("      0 + Z\n") != plot.npos);
    CHECK(plot.find("x") < plot.find("Z"));
}

TEST_CASE("points that cannot be drawn are left out") {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const PlotFrame frame{.columns = 8, .rows = 4, .x_name = "", .y_name = ""};
    CHECK(log_log_plot({}, frame).empty());
    CHECK(log_log_plot(std::vector<PlotPoint>{{0, 1, 'q', false}, {1, infinity, 'q', false}}, frame)
              .empty());
    const std::string plot =
        log_log_plot(std::vector<PlotPoint>{{1, infinity, 'q', false}, {2, 2, 'x', false}}, frame);
    CHECK(plot.find('q') == plot.npos);
    CHECK(plot.find('x') != plot.npos);
}

TEST_CASE("a point on the front is drawn over others in its cell") {
    const PlotFrame frame{.columns = 8, .rows = 4, .x_name = "", .y_name = ""};
    const std::string plot = log_log_plot(
        std::vector<PlotPoint>{{1, 1, 'F', true}, {1, 1, 'x', false}, {1, 1, 'y', false}}, frame);
    CHECK(plot.find('F') != plot.npos);
    CHECK(plot.find('y') == plot.npos);
}
