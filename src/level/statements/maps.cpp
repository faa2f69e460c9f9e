#include <fmt/format.h>

#include <set>

#include "level/ir/arguments.h"
#include "level/ir/emit.h"
#include "level/statements/families.h"
#include "level/statements/keys.h"
#include "level/text/lookalikes.h"
#include "level/text/utf8.h"

namespace carom {
namespace {

constexpr double peg_share = 0.25;  // default radius of a peg, in cells

// The cells of a drawing: one character each.
class Drawing {
  public:
    explicit Drawing(const std::vector<Word>& lines) : lines_(lines) {
        for (const Word& line : lines) {
            std::vector<std::string_view> row;
            for (std::size_t i = 0; i < line.text.size();) {
                std::size_t end = i + 1;
                while (end < line.text.size() && continues_sequence(line.text[end]))
                    ++end;
                row.push_back(line.text.substr(i, end - i));
                i = end;
            }
            columns_ = std::max(columns_, static_cast<int>(row.size()));
            cells_.push_back(std::move(row));
        }
    }

    int rows() const { return static_cast<int>(cells_.size()); }
    int columns() const { return columns_; }
    /// The number of characters in the row.
    int length(int row) const {
        return static_cast<int>(cells_[static_cast<std::size_t>(row)].size());
    }
    /// The character of a cell; blank outside of the drawing. Rows count from the top.
    std::string_view at(int row, int column) const {
        if (row < 0 || row >= rows() || column < 0) return " ";
        const auto& line = cells_[static_cast<std::size_t>(row)];
        if (column >= static_cast<int>(line.size())) return " ";
        return line[static_cast<std::size_t>(column)];
    }
    Span span(int row, int column) const {
        const Word& line = lines_[static_cast<std::size_t>(row)];
        return {line.source, line.line, column + 1, 1};
    }

  private:
    const std::vector<Word>& lines_;
    std::vector<std::vector<std::string_view>> cells_;
    int columns_ = 0;
};

class MapBuilder {
  public:
    MapBuilder(const Arguments& arguments, const Frame& frame, Context& context)
        : arguments_(arguments),
          frame_(frame),
          context_(context),
          drawing_(arguments.node->drawing),
          cell_(arguments.number_or("cell", 1.0)),
          corner_(arguments.pair_or("at", {})) {
        // Building looks at each place of the drawing several times.
        constexpr std::uint64_t cost_of_a_place = 4;
        context.work.spend(cost_of_a_place * static_cast<std::uint64_t>(drawing_.rows() + 1) *
                           static_cast<std::uint64_t>(drawing_.columns() + 1));
    }

    void build() {
        if (!check_letters()) return;
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
    // What a letter means; null: nothing. A built-in letter keeps its meaning unless a legend of
    // the level redefines it.
    const LegendIr* legend_of(std::string_view letter) const {
        static const LegendIr solid{.what = LegendIr::What::solid};
        static const LegendIr ball{.what = LegendIr::What::ball};
        static const LegendIr peg{.what = LegendIr::What::peg};
        if (letter == " ") return nullptr;
        const auto found = context_.ir.legends.find(letter);
        if (found != context_.ir.legends.end()) return &found->second;
        return letter == "#" ? &solid : letter == "o" ? &ball : letter == "*" ? &peg : nullptr;
    }

    static bool is_line(std::string_view c) {
        return c == "-" || c == "|" || c == "/" || c == "\\";
    }

    bool joins(int row, int column) const {
        const std::string_view c = drawing_.at(row, column);
        return is_line(c) || is_joint(c);
    }

    // A joint draws nothing, but lines that run into it meet at its centre.
    bool is_joint(std::string_view c) const { return c == "+" && !legend_of(c); }

    // A character with a meaning in drawings.
    bool is_known(std::string_view c) const {
        return c == " " || c == "." || is_line(c) || is_joint(c) || legend_of(c);
    }

    // Reports each unknown character once, and a comment as such.
    bool check_letters() {
        bool is_valid = true;
        for (int row = 0; row < drawing_.rows(); ++row) {
            int last = drawing_.length(row);
            if (const std::optional<int> comment = comment_in(row)) {
                context_.reporter.error("comment-in-map", drawing_.span(row, *comment),
                                        "a drawing cannot have comments",
                                        "write it above the map, or below its end");
                is_valid = false;
                last = *comment;
            }
            for (int column = 0; column < last; ++column) {
                const std::string_view c = drawing_.at(row, column);
                if (is_known(c)) continue;
                is_valid = false;
                if (reported_.insert(c).second) report_letter(c, drawing_.span(row, column));
            }
        }
        return is_valid;
    }

    void report_letter(std::string_view c, const Span& at) {
        if (c == "\t")
            return context_.reporter.error("map-tab", at, "a tab stands in the drawing",
                                           "write blanks");
        if (const Lookalike* like = lookalike(decode_utf8(c).character))
            return context_.reporter.error("lookalike", at,
                                           fmt::format("{} stands here", like->name),
                                           std::string(like->remedy));
        context_.reporter.error("map-letter-unknown", at,
                                fmt::format("'{}' means nothing in a drawing", c),
                                fmt::format("explain it above: legend ball {} kind=NAME", c));
    }

    // The column at which a comment begins: a mark of comments, and behind it a word of three
    // letters or more, one of them unknown.
    std::optional<int> comment_in(int row) const {
        const auto is_mark = [&](int column) {
            const std::string_view c = drawing_.at(row, column);
            return c == "#" || c == ";" ||
                   ((c == "/" || c == "-") && drawing_.at(row, column + 1) == c);
        };
        std::optional<int> mark;
        int letters = 0;
        bool has_unknown = false;
        for (int column = 0; column < drawing_.length(row); ++column) {
            const std::string_view c = drawing_.at(row, column);
            if (!mark && is_mark(column)) mark = column;
            const bool is_letter = is_identifier(c);
            letters = is_letter ? letters + 1 : 0;
            has_unknown = is_letter && ((letters > 1 && has_unknown) || !is_known(c));
            if (mark && has_unknown && letters >= 3) return mark;
        }
        return std::nullopt;
    }

    // The upper left corner of the cell in this row and column, in the coordinates of the frame.
    Vec2 point(double row, double column) const {
        return corner_ + Vec2{column * cell_, (drawing_.rows() - row) * cell_};
    }

    void build_cell(int row, int column) {
        const std::string_view c = drawing_.at(row, column);
        if (c == " " || c == "." || is_joint(c)) return;
        if (c == "-") return build_run(row, column, 0, 1, {0.5, 0.0}, {0.5, 1.0});
        if (c == "|") return build_run(row, column, 1, 0, {0.0, 0.5}, {1.0, 0.5});
        if (c == "/") return build_run(row, column, 1, -1, {0.0, 1.0}, {1.0, 0.0});
        if (c == "\\") return build_run(row, column, 1, 1, {0.0, 0.0}, {1.0, 1.0});
        const LegendIr& legend = *legend_of(c);
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
        ball.origin.span = drawing_.span(row, column);
        emit_ball(ball, frame_, context_);
    }

    const LegendIr* solid_at(int row, int column) const {
        const LegendIr* legend = legend_of(drawing_.at(row, column));
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
        if (!edges.material) edges.material = arguments_.word("material");
        return bind_edges(std::move(edges), context_);
    }

    const Arguments& arguments_;
    const Frame& frame_;
    Context& context_;
    Drawing drawing_;
    double cell_;
    Vec2 corner_;
    std::set<std::string_view> reported_;  ///< unknown characters
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
         .usage = "map cell=S [at=X,Y] [r=] [kind=] [material=] ... end",
         .action = build_map,
         .opens_block = true,
         .body_is_drawing = true,
         .keys = {{"cell", scalar, length, positive, true},
                  {"at", pair, length},
                  keys::edge_radius,
                  keys::kind,
                  keys::material}},
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
