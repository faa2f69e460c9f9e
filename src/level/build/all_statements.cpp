#include "level/build/all_statements.h"

#include "level/build/block_statements.h"
#include "level/statements/families.h"

namespace carom {
namespace {

std::vector<Statement> rows_of_all_families() {
    std::vector<Statement> rows;
    for (const auto family :
         {header_statements, variable_statements, setting_statements, class_statements,
          ball_statements, shape_statements, galton_statements, pool_statements, block_statements,
          map_statements, pinball_statements, pinball_zone_statements, pinball_holder_statements,
          game_statements, motion_statements, seesaw_statements, dress_statements,
          amendment_statements, experiment_statements}) {
        for (Statement& row : family())
            rows.push_back(std::move(row));
    }
    rows.push_back({.name = "end", .usage = "end"});
    return rows;
}

}  // namespace

const StatementTable& all_statements() {
    static const StatementTable table(rows_of_all_families());
    return table;
}

}  // namespace carom
