#include <algorithm>

#include "terminal/canvas/character_width.h"
#include "terminal/panels/pages.h"
#include "terminal/panels/panel.h"

/// The menu: a list of levels, and a description of the selected one.
namespace carom {

namespace {

constexpr int title_rows = 2;
constexpr int least_beside = 72;  ///< columns from which the preview is drawn beside the list

// The layout of the menu.
struct MenuLayout {
    CellArea list;
    CellArea preview;
};

MenuLayout layout_of(int columns, int rows, std::span<const MenuEntry> entries) {
    const int body = std::max(0, rows - title_rows - 1);
    if (columns < least_beside) {
        const int below = body >= 12 ? body / 3 : 0;
        return {{1, title_rows, columns - 2, body - below},
                {1, title_rows + body - below + 1, columns - 2, below - 1}};
    }
    int names = 0;
    int titles = 0;
    for (const MenuEntry& entry : entries) {
        names = std::max(names, columns_of(entry.name));
        titles = std::max(titles, columns_of(entry.title));
    }
    const int widest = names + titles + 4;
    const int list = std::clamp(widest, 30, columns / 2);
    return {{1, title_rows, list, body}, {list + 4, title_rows, columns - list - 5, body}};
}

// A row of the list: an entry, or the heading of a group (then `entry` is none).
struct ListRow {
    std::optional<std::size_t> entry;
    std::string_view heading;
};

std::vector<ListRow> rows_of(std::span<const MenuEntry> entries) {
    std::vector<ListRow> rows;
    std::string_view group;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        if (entries[i].group != group) {
            group = entries[i].group;
            if (!rows.empty()) rows.push_back({});
            rows.push_back({std::nullopt, group});
        }
        rows.push_back({i, {}});
    }
    return rows;
}

// The first visible row of the list; the selected entry stays near the middle.
std::size_t first_row_of(const std::vector<ListRow>& rows, std::size_t selected, int room) {
    const auto height = static_cast<std::size_t>(std::max(1, room));
    if (rows.size() <= height) return 0;
    std::size_t at = 0;
    while (at < rows.size() && rows[at].entry != selected)
        ++at;
    const std::size_t middle = at > height / 2 ? at - height / 2 : 0;
    return std::min(middle, rows.size() - height);
}

int name_width(std::span<const MenuEntry> entries, int columns) {
    int width = 0;
    for (const MenuEntry& entry : entries)
        width = std::max(width, columns_of(entry.name));
    return std::min(width, columns / 2);
}

void draw_entry(Canvas& canvas, const CellArea& area, int row, const MenuEntry& entry,
                int name_columns, bool is_selected, const Look& look) {
    const std::uint8_t marked = is_selected ? reverse : plain;
    Ink name = ink_of(entry.is_broken ? Role::error : Role::strong, look);
    Ink title = ink_of(Role::text, look);
    name.attributes = static_cast<std::uint8_t>((name.attributes & ~reverse) | marked);
    title.attributes |= marked;
    if (is_selected) {
        for (int column = 0; column < area.columns; ++column) {
            canvas.put(area.column + column, area.row + row,
                       {U' ', default_color, default_color, reverse});
        }
    }
    write_cut(canvas, area, row, is_selected ? ">" : " ", title);
    const CellArea names{area.column + 2, area.row, name_columns, area.rows};
    const CellArea titles{names.column + name_columns + 2, area.row,
                          area.columns - name_columns - 4, area.rows};
    write_cut(canvas, names, row, entry.name, name);
    write_cut(canvas, titles, row, entry.title, title);
}

// The preview as drawn. The author broke its paragraphs into lines for an editor; these are joined
// and broken again for this window.
std::vector<std::string> preview_lines(const MenuEntry& entry, int columns) {
    // A line this long continues in the next, unless blanks lay it out as a list or the next line
    // is indented.
    constexpr int full_line = 70;
    std::vector<std::string> lines;
    std::string paragraph;
    for (std::size_t i = 0; i < entry.preview.size(); ++i) {
        const std::string& line = entry.preview[i];
        const std::string_view next =
            i + 1 < entry.preview.size() ? std::string_view(entry.preview[i + 1]) : "";
        paragraph += line;
        const bool continues_line = columns_of(line) >= full_line &&
                                    line.find("   ") == std::string::npos && !next.empty() &&
                                    next.front() != ' ';
        if (continues_line) {
            paragraph += ' ';
            continue;
        }
        for (std::string& part : wrapped(paragraph, columns))
            lines.push_back(std::move(part));
        paragraph.clear();
    }
    return lines;
}

// The number of rows that the text of the preview takes, including a blank row below it.
int words_rows(const MenuEntry& entry, int columns) {
    return 3 + static_cast<int>(preview_lines(entry, columns).size());
}

void draw_preview(Canvas& canvas, const CellArea& area, const MenuEntry& entry, const Look& look) {
    if (area.rows < 2 || area.columns < 8) return;
    write_cut(canvas, area, 0, entry.title, ink_of(Role::strong, look));
    int row = 2;
    for (const std::string& line : preview_lines(entry, area.columns)) {
        write_cut(canvas, area, row++, line, ink_of(Role::text, look));
    }
}

}  // namespace

void draw_menu(Canvas& canvas, std::span<const MenuEntry> entries, std::size_t selected,
               std::string_view footer, const Look& look) {
    canvas.fill({});
    const Ink strong = ink_of(Role::strong, look);
    const Ink faint = ink_of(Role::faint, look);
    canvas.write(1, 0, "carom", strong.color, default_color, strong.attributes);
    canvas.write(8, 0, "pick a level", faint.color, default_color, faint.attributes);
    canvas.write(1, canvas.rows() - 1, footer, faint.color, default_color, faint.attributes);

    const MenuLayout layout = layout_of(canvas.columns(), canvas.rows(), entries);
    const std::vector<ListRow> rows = rows_of(entries);
    const std::size_t first = first_row_of(rows, selected, layout.list.rows);
    const int name_columns = name_width(entries, layout.list.columns);
    for (int row = 0; row < layout.list.rows; ++row) {
        const std::size_t i = first + static_cast<std::size_t>(row);
        if (i >= rows.size()) break;
        if (rows[i].entry) {
            draw_entry(canvas, layout.list, row, entries[*rows[i].entry], name_columns,
                       rows[i].entry == selected, look);
        } else {
            write_cut(canvas, layout.list, row, rows[i].heading, faint);
        }
    }
    if (selected < entries.size()) draw_preview(canvas, layout.preview, entries[selected], look);
}

std::optional<std::size_t> menu_entry_at(int columns, int rows, std::span<const MenuEntry> entries,
                                         std::size_t selected, int column, int row) {
    const CellArea list = layout_of(columns, rows, entries).list;
    const bool is_in_list = column >= list.column && column < list.column + list.columns &&
                            row >= list.row && row < list.row + list.rows;
    if (!is_in_list) return std::nullopt;
    const std::vector<ListRow> all = rows_of(entries);
    const std::size_t i =
        first_row_of(all, selected, list.rows) + static_cast<std::size_t>(row - list.row);
    return i < all.size() ? all[i].entry : std::nullopt;
}

CellArea menu_picture_area(int columns, int rows, std::span<const MenuEntry> entries,
                           std::size_t selected) {
    const CellArea preview = layout_of(columns, rows, entries).preview;
    if (selected >= entries.size() || columns < least_beside) return {};
    const int words = words_rows(entries[selected], preview.columns);
    const CellArea picture{preview.column, preview.row + words, preview.columns,
                           preview.rows - words};
    return picture.rows >= 5 ? picture : CellArea{};
}

}  // namespace carom
