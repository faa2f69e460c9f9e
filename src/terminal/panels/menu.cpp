#include "terminal/panels/menu.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "terminal/canvas/character_width.h"
#include "terminal/panels/panel.h"

namespace carom {

namespace {

constexpr int first_list_row = 3;  // below the name, the tabs and a rule
constexpr int least_beside = 60;   // columns from which on the picture is beside the list
constexpr int words_rows = 6;      // below the picture
constexpr int least_picture = 5;   // rows
constexpr int widest_title = 34;

struct Areas {
    CellArea list;
    CellArea words;
    CellArea picture;
};

// `shape`: that of the picture. What it leaves free below goes to the words.
Areas areas_of(int columns, int rows, double shape) {
    const int body = std::max(0, rows - first_list_row - 1);
    if (columns < least_beside) {
        const int words = body >= 12 ? words_rows - 1 : 0;
        return {{0, first_list_row, columns, body - words},
                {1, first_list_row + body - words + 1, columns - 2, words - 1},
                {}};
    }
    const int list = std::clamp(columns * 9 / 20, 34, 76);
    const int left = list + 3;
    const int right = columns - left - 1;
    const int words = std::min(words_rows, body);
    CellArea picture{left, first_list_row, right, body - words - 1};
    if (picture.rows < least_picture) picture = {};
    if (shape > 0.0) {
        const double needed = std::max(right * shape, least_picture * 1.0);
        picture.rows = static_cast<int>(std::ceil(std::min<double>(picture.rows, needed)));
    }
    const int below = picture.rows > 0 ? first_list_row + picture.rows + 1 : first_list_row;
    return {{0, first_list_row, list, body},
            {left, below, right, first_list_row + body - below},
            picture};
}

// The first visible entry; the selected one stays near the middle.
std::size_t first_entry(std::size_t count, std::size_t selected, int room) {
    const auto height = static_cast<std::size_t>(std::max(1, room));
    if (count <= height) return 0;
    const std::size_t middle = selected > height / 2 ? selected - height / 2 : 0;
    return std::min(middle, count - height);
}

struct Tab {
    std::size_t group;
    int column;
    int columns;
};

// Tabs stand closer where that makes room for all. Those that still do not fit are left out from
// the far end, but never the open one.
std::vector<Tab> tabs_of(const MenuPage& page, int columns) {
    int all = 0;
    for (const std::string& group : page.groups)
        all += columns_of(group) + 3;
    const int gap = all - 1 <= columns ? 1 : 0;
    std::size_t first = 0;
    for (;; ++first) {
        std::vector<Tab> tabs;
        int column = 0;
        for (std::size_t i = first; i < page.groups.size(); ++i) {
            const int width = columns_of(page.groups[i]) + 2;
            if (column + width > columns) break;
            tabs.push_back({i, column, width});
            column += width + gap;
        }
        const bool has_open = !tabs.empty() && tabs.back().group >= page.group;
        if (has_open || first >= page.group || first + 1 >= page.groups.size()) return tabs;
    }
}

void fill_row(Canvas& canvas, int row, int from, int to, std::uint8_t attributes) {
    for (int column = from; column < to; ++column)
        canvas.put(column, row, {U' ', default_color, default_color, attributes});
}

int write(Canvas& canvas, int column, int row, std::string_view text, Ink ink,
          std::uint8_t attributes = plain) {
    return canvas.write(column, row, text, ink.color, default_color,
                        static_cast<std::uint8_t>(ink.attributes | attributes));
}

// Three balls, the name, and what carom is.
void draw_name(Canvas& canvas, const Look& look) {
    const std::string_view ball = look.utf8 ? "●" : "o";
    int column = 1;
    for (const std::size_t kind : {1u, 0u, 2u})
        column = write(canvas, column, 0, ball, ink_of_class(kind, look)) + (look.utf8 ? 1 : 0);
    column = write(canvas, column + 1, 0, "c a r o m", ink_of(Role::strong, look)) + 3;
    constexpr std::string_view what = "pool, pinball and a physics laboratory";
    if (column + columns_of(what) < canvas.columns())
        write(canvas, column, 0, what, ink_of(Role::faint, look));
}

void draw_tabs(Canvas& canvas, const MenuPage& page, const Look& look) {
    for (const Tab& tab : tabs_of(page, canvas.columns())) {
        const bool is_open = page.search.empty() && tab.group == page.group;
        write(canvas, tab.column, 1, " " + page.groups[tab.group] + " ",
              ink_of(is_open ? Role::strong : Role::text, look), is_open ? reverse : plain);
    }
    const std::vector<Tab> tabs = tabs_of(page, canvas.columns());
    const bool has_more = !tabs.empty() && tabs.back().group + 1 < page.groups.size();
    if (has_more && tabs.back().column + tabs.back().columns < canvas.columns())
        write(canvas, canvas.columns() - 1, 1, look.utf8 ? "›" : ">", ink_of(Role::faint, look));
    const std::string_view line = look.utf8 ? "─" : "-";
    for (int column = 0; column < canvas.columns(); ++column)
        write(canvas, column, 2, line, ink_of(Role::faint, look));
}

void draw_entry(Canvas& canvas, const CellArea& area, int row, const MenuEntry& entry,
                bool is_selected, int title_columns, bool shows_line, const Look& look) {
    const std::uint8_t marked = is_selected ? reverse : plain;
    if (is_selected)
        fill_row(canvas, area.row + row, area.column, area.column + area.columns, marked);
    Ink title = ink_of(entry.is_broken ? Role::error : Role::strong, look);
    Ink faint = ink_of(Role::faint, look);
    // A reversed faint ink is hard to read.
    if (is_selected) title = faint = {default_color, plain};
    title.attributes |= marked;
    faint.attributes |= marked;
    const int badge = columns_of(entry.badge);
    const int right = area.columns - 1 - (badge > 0 ? badge + 1 : 0);
    write_cut(canvas, {area.column, area.row, 2, area.rows}, row, is_selected ? " >" : "", title);
    const CellArea titles{area.column + 3, area.row, right - 3, area.rows};
    write_cut(canvas, titles, row, entry.title, title);
    const CellArea lines{area.column + 5 + title_columns, area.row, right - 5 - title_columns,
                         area.rows};
    if (shows_line) write_cut(canvas, lines, row, entry.line, faint);
    if (badge > 0)
        write(canvas, area.column + area.columns - 1 - badge, area.row + row, entry.badge,
              is_selected ? title : ink_of(Role::warning, look), marked);
}

void draw_list(Canvas& canvas, const MenuPage& page, const CellArea& area, const Look& look) {
    const std::size_t first = first_entry(page.entries.size(), page.selected, area.rows);
    int titles = 0;
    int lines = 0;
    for (const MenuEntry& entry : page.entries) {
        titles = std::max(titles, std::min(widest_title, columns_of(entry.title)));
        const int badge = columns_of(entry.badge);
        lines = std::max(lines, columns_of(entry.line) + (badge > 0 ? badge + 1 : 0));
    }
    const bool shows_line = 5 + titles + lines + 1 <= area.columns;
    for (int row = 0; row < area.rows; ++row) {
        const std::size_t i = first + static_cast<std::size_t>(row);
        if (i < page.entries.size())
            draw_entry(canvas, area, row, page.entries[i], i == page.selected, titles, shows_line,
                       look);
    }
}

void draw_words(Canvas& canvas, const MenuPage& page, const CellArea& area, const Look& look) {
    if (page.selected >= page.entries.size() || area.rows < 1 || area.columns < 8) return;
    const MenuEntry& entry = page.entries[page.selected];
    int row = 0;
    const auto add = [&](std::string_view text, Role role) {
        if (text.empty()) return;
        for (const std::string& line : wrapped(text, area.columns))
            if (row < area.rows) write_cut(canvas, area, row++, line, ink_of(role, look));
    };
    add(entry.line.empty() ? entry.title : entry.line, Role::strong);
    if (!page.goal.empty()) add("Goal: " + page.goal, Role::warning);
    for (const std::string& note : page.notes)
        add(note, Role::text);
    ++row;
    constexpr int widest = 76;  // a line that the eye can follow
    draw_items(canvas,
               {area.column, area.row + row, std::min(widest, area.columns), area.rows - row},
               page.about, look);
}

}  // namespace

void draw_menu(Canvas& canvas, const MenuPage& page, const Look& look) {
    canvas.fill({});
    draw_name(canvas, look);
    draw_tabs(canvas, page, look);
    const bool has_message = !page.message.empty();
    write(canvas, 1, canvas.rows() - 1, has_message ? page.message : page.footer,
          ink_of(has_message ? Role::warning : Role::faint, look));
    const Areas areas = areas_of(canvas.columns(), canvas.rows(), page.picture_shape);
    draw_list(canvas, page, areas.list, look);
    draw_words(canvas, page, areas.words, look);
}

std::optional<std::size_t> menu_entry_at(int columns, int rows, const MenuPage& page, int column,
                                         int row) {
    const CellArea list = areas_of(columns, rows, page.picture_shape).list;
    const bool is_in_list = column >= list.column && column < list.column + list.columns &&
                            row >= list.row && row < list.row + list.rows;
    if (!is_in_list) return std::nullopt;
    const std::size_t i = first_entry(page.entries.size(), page.selected, list.rows) +
                          static_cast<std::size_t>(row - list.row);
    return i < page.entries.size() ? std::optional(i) : std::nullopt;
}

std::optional<std::size_t> menu_group_at(int columns, const MenuPage& page, int column, int row) {
    if (row != 1) return std::nullopt;
    for (const Tab& tab : tabs_of(page, columns))
        if (column >= tab.column && column < tab.column + tab.columns) return tab.group;
    return std::nullopt;
}

CellArea menu_picture_area(int columns, int rows, const MenuPage& page) {
    return page.selected < page.entries.size() ? areas_of(columns, rows, page.picture_shape).picture
                                               : CellArea{};
}

}  // namespace carom
