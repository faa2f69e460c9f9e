#include "terminal/screen/picture_text.h"

#include <fmt/format.h>

#include <compare>
#include <cstddef>
#include <iterator>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "level/text/utf8.h"
#include "terminal/canvas/mosaic.h"
#include "terminal/screen/sgr.h"

namespace carom {

namespace {

constexpr int cell_width = 10;
constexpr int cell_height = 20;
// The finest division of a cell by a shape: halves across; eighths, thirds and quarters down.
constexpr int parts_across = 2;
constexpr int parts_down = 24;

// A character that divides its cell in across * down parts.
struct Division {
    int across = 1;
    int down = 1;
    unsigned pattern = 0;
};

std::map<char32_t, Division> all_divisions() {
    std::map<char32_t, Division> divisions;
    for (unsigned i = 1; i < 4; ++i)
        divisions.insert({half_block(i), {1, 2, i}});
    for (unsigned i = 1; i < 16; ++i)
        divisions.insert({quadrant(i), {2, 2, i}});
    for (unsigned i = 1; i < 64; ++i)
        divisions.insert({sextant(i), {2, 3, i}});
    for (unsigned i = 1; i < 256; ++i)
        divisions.insert({octant(i), {2, 4, i}});
    // Lower blocks of one to seven eighths.
    for (unsigned i = 1; i < 8; ++i)
        divisions.insert({U'▁' + i - 1, {1, 8, 0xffu << (8 - i) & 0xffu}});
    divisions.erase(U' ');
    return divisions;
}

std::optional<Division> division_of(char32_t glyph) {
    static const std::map<char32_t, Division> divisions = all_divisions();
    const auto found = divisions.find(glyph);
    if (found == divisions.end()) return std::nullopt;
    return found->second;
}

bool is_braille(char32_t glyph) {
    return glyph >= 0x2800 && glyph <= 0x28ff;
}

std::string hex(Color color) {
    const Rgb rgb = rgb_of(color);
    return fmt::format("#{:02x}{:02x}{:02x}", rgb.red, rgb.green, rgb.blue);
}

struct CellColors {
    Color ink = default_color;
    Color ground = default_color;
};

CellColors colors_of(const Cell& cell, const Look& look) {
    CellColors colors{cell.foreground == default_color ? foreground_color(look) : cell.foreground,
                      cell.background == default_color ? ground_color(look) : cell.background};
    if (cell.attributes & dim) colors.ink = mixed(colors.ink, colors.ground, 0.6);
    if (cell.attributes & reverse) std::swap(colors.ink, colors.ground);
    return colors;
}

// The parts of a row of cells, line by line.
using Lines = std::vector<std::vector<Color>>;

Lines lines_of_row(const Canvas& canvas, int row, const Look& look) {
    const auto across = static_cast<std::size_t>(canvas.columns() * parts_across);
    Lines lines(parts_down, std::vector<Color>(across, default_color));
    for (int column = 0; column < canvas.columns(); ++column) {
        const Cell& cell = canvas.at(column, row);
        const CellColors colors = colors_of(cell, look);
        const auto division = division_of(cell.glyph);
        for (int y = 0; y < parts_down; ++y) {
            for (int x = 0; x < parts_across; ++x) {
                Color color = colors.ground;
                if (division) {
                    const int part = y * division->down / parts_down * division->across +
                                     x * division->across / parts_across;
                    if (division->pattern >> part & 1u) color = colors.ink;
                }
                lines[static_cast<std::size_t>(y)]
                     [static_cast<std::size_t>(column * parts_across + x)] = color;
            }
        }
    }
    return lines;
}

// Rectangles of one colour, as high as they can be, so that a viewer shows few seams.
class Rectangles {
  public:
    explicit Rectangles(Color ground) : ground_(ground) {}

    /// Adds the next line from the top.
    void add(const std::vector<Color>& line) {
        Open continued;
        for (std::size_t first = 0; first < line.size();) {
            std::size_t last = first + 1;
            while (last < line.size() && line[last] == line[first])
                ++last;
            if (line[first] != ground_) {
                const Run run{first, last, line[first]};
                const auto above = open_.find(run);
                continued[run] = above == open_.end() ? line_ : above->second;
                if (above != open_.end()) open_.erase(above);
            }
            first = last;
        }
        close();
        open_ = std::move(continued);
        ++line_;
    }

    /// The data of a path for each colour, once all lines are added.
    std::map<Color, std::string> paths() {
        close();
        return std::move(paths_);
    }

  private:
    struct Run {
        std::size_t first = 0;
        std::size_t last = 0;
        Color color = default_color;

        friend auto operator<=>(const Run&, const Run&) = default;
    };
    using Open = std::map<Run, int>;  // with the line on which each begins

    void close() {
        constexpr int unit = cell_width / parts_across;
        constexpr double height = static_cast<double>(cell_height) / parts_down;
        for (const auto& [run, top] : open_)
            paths_[run.color] += fmt::format("M{} {:.6g}h{}v{:.6g}h-{}z", run.first * unit,
                                             top * height, (run.last - run.first) * unit,
                                             (line_ - top) * height, (run.last - run.first) * unit);
        open_.clear();
    }

    Color ground_;
    int line_ = 0;
    Open open_;
    std::map<Color, std::string> paths_;
};

// Bits of U+2800: dots 1 to 8.
void add_dots(std::string& svg, const Canvas& canvas, int column, int row, const Look& look) {
    constexpr int places[8][2] = {{0, 0}, {0, 1}, {0, 2}, {1, 0}, {1, 1}, {1, 2}, {0, 3}, {1, 3}};
    const Cell& cell = canvas.at(column, row);
    for (int dot = 0; dot < 8; ++dot)
        if ((cell.glyph - 0x2800) >> dot & 1u)
            svg += fmt::format("<circle cx=\"{:.4g}\" cy=\"{:.4g}\" r=\"1.8\" fill=\"{}\"/>\n",
                               column * cell_width + 2.5 + 5.0 * places[dot][0],
                               row * cell_height + 2.5 + 5.0 * places[dot][1],
                               hex(colors_of(cell, look).ink));
}

bool is_text(const Cell& cell) {
    return cell.glyph != U' ' && !division_of(cell.glyph) && !is_braille(cell.glyph);
}

std::string escaped(char32_t glyph) {
    if (glyph == U'&') return "&amp;";
    if (glyph == U'<') return "&lt;";
    if (glyph == U'>') return "&gt;";
    std::string text;
    append_utf8(text, glyph);
    return text;
}

// Writes the text that begins in this cell. Returns the column after it.
int add_text(std::string& svg, const Canvas& canvas, int column, int row, const Look& look) {
    const Cell& first = canvas.at(column, row);
    const Color ink = colors_of(first, look).ink;
    std::string text;
    int end = column;
    for (; end < canvas.columns(); ++end) {
        const Cell& cell = canvas.at(end, row);
        const bool goes_on = is_text(cell) && cell.attributes == first.attributes &&
                             colors_of(cell, look).ink == ink;
        if (!goes_on) break;
        text += escaped(cell.glyph);
    }
    svg += fmt::format("<text x=\"{}\" y=\"{}\" textLength=\"{}\" fill=\"{}\"{}{}>{}</text>\n",
                       column * cell_width, row * cell_height + 15, (end - column) * cell_width,
                       hex(ink), first.attributes & bold ? " font-weight=\"bold\"" : "",
                       first.attributes & underline ? " text-decoration=\"underline\"" : "", text);
    return end;
}

}  // namespace

std::string ansi_of(const Canvas& canvas) {
    std::string text;
    for (int row = 0; row < canvas.rows(); ++row) {
        SgrStyle style;
        for (int column = 0; column < canvas.columns(); ++column) {
            const Cell& cell = canvas.at(column, row);
            const SgrStyle wanted{cell.foreground, cell.background, cell.attributes};
            text += style_change(style, wanted, true).text();
            append_utf8(text, cell.glyph);
            style = wanted;
        }
        text += style_change(style, {}, true).text();
        text += '\n';
    }
    return text;
}

std::string svg_of(const Canvas& canvas, const Look& look) {
    const int width = canvas.columns() * cell_width;
    const int height = canvas.rows() * cell_height;
    const Color ground = ground_color(look);
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
        "height=\"{1}\" font-family=\"DejaVu Sans Mono, Menlo, Consolas, monospace\" "
        "font-size=\"16.6\">\n<rect width=\"{0}\" height=\"{1}\" fill=\"{2}\"/>\n"
        "<g shape-rendering=\"crispEdges\">\n",
        width, height, hex(ground));
    Rectangles rectangles(ground);
    for (int row = 0; row < canvas.rows(); ++row)
        for (const std::vector<Color>& line : lines_of_row(canvas, row, look))
            rectangles.add(line);
    for (const auto& [color, path] : rectangles.paths())
        svg += fmt::format("<path fill=\"{}\" d=\"{}\"/>\n", hex(color), path);
    svg += "</g>\n";
    for (int row = 0; row < canvas.rows(); ++row) {
        for (int column = 0; column < canvas.columns();) {
            const Cell& cell = canvas.at(column, row);
            if (is_braille(cell.glyph)) add_dots(svg, canvas, column, row, look);
            column = is_text(cell) ? add_text(svg, canvas, column, row, look) : column + 1;
        }
    }
    return svg + "</svg>\n";
}

}  // namespace carom
