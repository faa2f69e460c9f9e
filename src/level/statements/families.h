#pragma once

#include <vector>

#include "level/language/statement.h"

/// The families of statements. Each file holds the rows of its statements and their functions, so
/// that a new statement is a row and a function in one file.
namespace carom {

std::vector<Statement> header_statements();   ///< carom, physics, units (header.cpp)
std::vector<Statement> setting_statements();  ///< world, use, collide, solver, rate, seed
std::vector<Statement> class_statements();    ///< kind, material (classes.cpp)
std::vector<Statement> ball_statements();     ///< ball, spawn, fill, cradle (balls.cpp)
std::vector<Statement> shape_statements();    ///< edge, arc, peg, box (shapes.cpp)
std::vector<Statement> galton_statements();   ///< pegs, bins, zone (galton.cpp)
std::vector<Statement> pool_statements();     ///< rack, pocket, cue (pool.cpp)
std::vector<Statement> map_statements();      ///< map, legend (maps.cpp)
std::vector<Statement> pinball_statements();  ///< devices that a ball hits (pinball.cpp)
std::vector<Statement>
pinball_zone_statements();  ///< devices that a ball enters (pinball_zones.cpp)
std::vector<Statement>
pinball_holder_statements();                ///< hole, lock, magnet, captive (pinball_holders.cpp)
std::vector<Statement> game_statements();   ///< game, on (games.cpp, rules.cpp)
std::vector<Statement> dress_statements();  ///< paint, label, insert, theme (dress.cpp)
std::vector<Statement> amendment_statements();   ///< move, remove (amendments.cpp)
std::vector<Statement> motion_statements();      ///< motion (motions.cpp)
std::vector<Statement> seesaw_statements();      ///< seesaw (seesaws.cpp)
std::vector<Statement> experiment_statements();  ///< show, expect (experiments.cpp)

}  // namespace carom
