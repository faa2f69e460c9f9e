#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>

/// Instructions, counted by callgrind: equal in every run, whatever else the machine does.
namespace carom::bench {

class InstructionCounter {
  public:
    /// `dumps`: the value of callgrind's --callgrind-out-file. Callgrind must have been started
    /// with --instr-atstart=no.
    explicit InstructionCounter(std::string dumps) : dumps_(std::move(dumps)) {}

    /// The instructions of `work`. Ends the process with a message if it does not run under
    /// callgrind.
    std::uint64_t count(const std::function<void()>& work);

  private:
    std::string dumps_;
    int dump_ = 0;
};

}  // namespace carom::bench
