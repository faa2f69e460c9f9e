#pragma once

namespace carom {

/// How an AI player chooses among the shots that it can make: what a shot is worth to it beyond
/// what the planner finds, on the planner's scale from -1 (lost) to 1 (won).
struct PlayStyle {
    double safety = 0.0;    ///< of a safety
    double risk = 0.0;      ///< of a pot, for the share of its trials that fail
    double pace = 0.0;      ///< of a pot, for each length/s of the stroke
    double position = 0.0;  ///< of a pot that leaves another, for the share that succeeds
    double pause = 1.2;     ///< s between announcing a shot and shooting it

    friend bool operator==(const PlayStyle&, const PlayStyle&) = default;
};

}  // namespace carom
