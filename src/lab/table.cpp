#include "lab/table.h"

#include <algorithm>
#include <cassert>

namespace carom {

Table::Table(const std::vector<std::string>& heads) {
    std::vector<std::string> names;
    for (const std::string& head : heads) {
        at_left_.push_back(head.starts_with('<'));
        names.push_back(at_left_.back() ? head.substr(1) : head);
    }
    rows_.push_back(std::move(names));
}

void Table::add(std::vector<std::string> cells) {
    assert(cells.size() == at_left_.size());
    rows_.push_back(std::move(cells));
}

std::string Table::text() const {
    std::vector<std::size_t> width(at_left_.size(), 0);
    for (const std::vector<std::string>& row : rows_) {
        for (std::size_t i = 0; i < row.size(); ++i)
            width[i] = std::max(width[i], row[i].size());
    }
    std::string text;
    for (const std::vector<std::string>& row : rows_) {
        std::string line;
        for (std::size_t i = 0; i < row.size(); ++i) {
            const std::string blanks(width[i] - row[i].size(), ' ');
            if (i > 0) line += "  ";
            line += at_left_[i] ? row[i] + blanks : blanks + row[i];
        }
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + '\n';
    }
    return text;
}

}  // namespace carom
