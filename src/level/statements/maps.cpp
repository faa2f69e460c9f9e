#include <fmt/format.h>

#include "level/ir/arguments.h"
#include "level/ir/emit.h"
#include "level/statements/drawing.h"
#include "level/statements/families.h"
#include "level/statements/keys.h"
#include "level/text/utf8.h"

namespace carom {
namespace {

constexpr double peg_share = 0.25;  // default radius of a peg, in cells

class MapBuilder {
  public:
    MapBuilder(const Arguments& arguments, const Frame& frame, Context& context)
        : arguments_(arguments),
          frame_(frame),
          context_(context),
          drawing_(arguments.node->drawing),
          letters_(context.ir),
          cell_(arguments.number_or("cell", 1.0)),
          corner_(arguments.pair_or("at", {})) {
        // Building looks at each place of the drawing several times.
        constexpr std::uint64_t cost_of_a_place = 4;
        context.work.spend(cost_of_a_place * static_cast<std::uint64_t>(drawing_.rows() + 1) *
                           static_cast<std::uint64_t>(drawing_.columns() + 1));
    }

    void build() {
        if (!letters_.check(drawing_, context_.reporter)) return;
        for (int row = 0; row < drawing_.rows(); ++row) {
            for (int column = 0; column < drawing_.columns(); ++column)
                build_cell(row, column);
        }
        for (int row = 0; row <= drawing_.rows(); ++row)
            outline_row(row);
        for (int column = 0; column <= drawing_.columns(); ++column)
            outline_column(column);
    }

  private:
    bool joins(int row, int column) const {
        const std::string_view c = drawing_.at(row, column);
        return DrawingLetters::is_line(c) || letters_.is_joint(c);
    }

    // The upper left corner of the cell in this row and column, in the coordinates of the frame.
    Vec2 point(double row, double column) const {
        return corner_ + Vec2{column * cell_, (drawing_.rows() - row) * cell_};
    }

    void build_cell(int row, int column) {
        const std::string_view c = drawing_.at(row, column);
        if (c == " " || c == "." || letters_.is_joint(c)) return;
        if (c == "-") return build_run(row, column, 0, 1, {0.5, 0.0}, {0.5, 1.0});
        if (c == "|") return build_run(row, column, 1, 0, {0.0, 0.5}, {1.0, 0.5});
        if (c == "/") return build_run(row, column, 1, -1, {0.0, 1.0}, {1.0, 0.0});
        if (c == "\\") return build_run(row, column, 1, 1, {0.0, 0.0}, {1.0, 1.0});
        const LegendIr& legend = *letters_.legend_of(c);
        const Vec2 middle = point(row + 0.5, column + 0.5);
        if (legend.what == LegendIr::What::ball) build_ball(legend, middle, row, column);
        if (legend.what == LegendIr::What::peg) {
            const double radius = legend.radius.value_or(peg_share * cell_);
            emit_capsule({middle, middle, radius}, Side::both, binding(legend.material),
                         begin_chain(false, context_), drawing_.span(row, column), frame_,
                         context_);
        }
    }

    // Draws a run of equal line characters as one edge. `from` and `to` are places (row, column)
    // within the first and the last cell.
    void build_run(int row, int column, int down, int right, Vec2 from, Vec2 to) {
        const std::string_view c = drawing_.at(row, column);
        if (drawing_.at(row - down, column - right) == c) return;  // not the first cell of its run
        int length = 1;
        while (drawing_.at(row + length * down, column + length * right) == c)
            ++length;
        const int last_row = row + (length - 1) * down;
        const int last_column = column + (length - 1) * right;
        // A line that ends at a cell of another line is extended to the centre of that cell and
        // joins it.
        const Vec2 half{0.5 * down, 0.5 * right};
        if (joins(row - down, column - right)) from -= half;
        if (joins(last_row + down, last_column + right)) to += half;
        add_edge(point(row + from.x, column + from.y), point(last_row + to.x, last_column + to.y),
                 std::nullopt, drawing_.span(row, column));
    }

    void build_ball(const LegendIr& legend, Vec2 middle, int row, int column) {
        BallIr ball;
        ball.position = middle;
        ball.velocity = legend.velocity;
        BallBinding balls;
        balls.node = arguments_.node;
        balls.kind = legend.kind ? legend.kind : arguments_.word("kind");
        if (!balls.kind) ball.radius = 0.5 * cell_;
        ball.binding = name_balls(std::move(balls), context_);
        ball.origin = Origin(drawing_.span(row, column));
        emit_ball(ball, frame_, context_);
    }

    const LegendIr* solid_at(int row, int column) const {
        const LegendIr* legend = letters_.legend_of(drawing_.at(row, column));
        return legend && legend->what == LegendIr::What::solid ? legend : nullptr;
    }

    // The legend of the edge between two cells of which exactly one is solid; null: no edge.
    static const LegendIr* rim(const LegendIr* a, const LegendIr* b) {
        if ((a == nullptr) == (b == nullptr)) return nullptr;
        return a ? a : b;
    }

    // Draws the edges between row - 1 and row. Adjacent edges of one legend become one edge.
    void outline_row(int row) {
        const auto rim_at = [&](int column) {
            return rim(solid_at(row - 1, column), solid_at(row, column));
        };
        for (int column = 0; column < drawing_.columns();) {
            const LegendIr* legend = rim_at(column);
            const int first = column++;
            if (!legend) continue;
            while (column < drawing_.columns() && rim_at(column) == legend)
                ++column;
            const int solid_row = solid_at(row, first) ? row : row - 1;
            add_edge(point(row, first), point(row, column), legend->material,
                     drawing_.span(solid_row, first));
        }
    }

    void outline_column(int column) {
        const auto rim_at = [&](int row) {
            return rim(solid_at(row, column - 1), solid_at(row, column));
        };
        for (int row = 0; row < drawing_.rows();) {
            const LegendIr* legend = rim_at(row);
            const int first = row++;
            if (!legend) continue;
            while (row < drawing_.rows() && rim_at(row) == legend)
                ++row;
            const int solid_column = solid_at(first, column) ? column : column - 1;
            add_edge(point(first, column), point(row, column), legend->material,
                     drawing_.span(first, solid_column));
        }
    }

    void add_edge(Vec2 from, Vec2 to, const std::optional<Word>& material, const Span& span) {
        emit_capsule({from, to, arguments_.number_or("r", 0.0)}, Side::both, binding(material),
                     begin_chain(false, context_), span, frame_, context_);
    }

    int binding(const std::optional<Word>& material) {
        EdgeBinding edges{arguments_.node, {}, false, material};
        edges.color = arguments_.color();
        if (!edges.material) edges.material = arguments_.word("material");
        return bind_edges(std::move(edges), context_);
    }

    const Arguments& arguments_;
    const Frame& frame_;
    Context& context_;
    Drawing drawing_;
    DrawingLetters letters_;
    double cell_;
    Vec2 corner_;
};

void build_map(const Arguments& arguments, const Frame& frame, Context& context) {
    MapBuilder(arguments, frame, context).build();
}

void add_legend(LegendIr::What what, const Arguments& arguments, Context& context) {
    const Word& letter = arguments.plain.front();
    if (characters(letter.text) != 1) {
        context.reporter.error("legend-of-several-letters", letter.span(),
                               "a legend explains one letter",
                               "write it as in: legend ball x kind=red");
        return;
    }
    LegendIr legend;
    legend.what = what;
    legend.kind = arguments.word("kind");
    legend.material = arguments.word("material");
    legend.radius = arguments.number("r");
    legend.velocity = arguments.pair_or("v", {});
    context.ir.legends[std::string(letter.text)] = legend;
}

Statement legend(std::string_view name, std::string_view usage, StatementAction action,
                 std::vector<KeyRule> keys) {
    return {.name = name,
            .usage = usage,
            .action = action,
            .place = Place::top,
            .plain_least = 1,
            .plain_most = 1,
            .keys = std::move(keys),
            .takes_lone_signs = true};
}

}  // namespace

std::vector<Statement> map_statements() {
    using enum KeyShape;
    using enum Bound;
    constexpr auto length = Measure::length;
    return {
        {.name = "map",
         .usage = "map cell=S [at=X,Y] [r=] [kind=] [material=] [color=] ... end",
         .action = build_map,
         .opens_block = true,
         .body_is_drawing = true,
         .keys = {{"cell", scalar, length, positive, true},
                  {"at", pair, length},
                  keys::edge_radius,
                  keys::kind,
                  keys::material,
                  keys::color}},
        legend("legend ball", "legend ball LETTER [kind=] [v=VX,VY]",
               [](const Arguments& arguments, const Frame&, Context& context) {
                   add_legend(LegendIr::What::ball, arguments, context);
               },
               {keys::kind, {"v", pair, Measure::speed}}),
        legend("legend peg", "legend peg LETTER [material=] [r=]",
               [](const Arguments& arguments, const Frame&, Context& context) {
                   add_legend(LegendIr::What::peg, arguments, context);
               },
               {keys::material, keys::edge_radius}),
        legend("legend solid", "legend solid LETTER [material=]",
               [](const Arguments& arguments, const Frame&, Context& context) {
                   add_legend(LegendIr::What::solid, arguments, context);
               },
               {keys::material}),
    };
}

}  // namespace carom
