#include "level/assemble/amend.h"

#include <fmt/format.h>

#include "level/text/spelling.h"

namespace carom {
namespace {

class Amending {
  public:
    Amending(std::vector<StartingBall>& balls, SymbolTable& symbols, Context& context)
        : balls_(balls), symbols_(symbols), context_(context), capsules_(context.ir.capsules) {}

    Amended run() {
        is_edge_removed_.assign(capsules_.size(), false);
        for (const AmendmentIr& amendment : context_.ir.amendments)
            if (!amendment.is_of_motion() && !amendment.is_of_seesaw()) apply(amendment);
        remove_edges();
        return std::move(result_);
    }

  private:
    void remove_edges() {
        std::vector<std::uint32_t> left;
        for (std::uint32_t i = 0; i < capsules_.size(); ++i)
            if (!is_edge_removed_[i]) left.push_back(i);
        if (left.size() == capsules_.size()) return;
        for (std::size_t i = 0; i < left.size(); ++i)
            capsules_[i] = capsules_[left[i]];
        capsules_.resize(left.size());
        symbols_.keep_edges(std::move(left));
    }

    void complain(const AmendmentIr& amendment, FaultCode fault, std::string what,
                  std::string remedy) {
        context_.reporter.error(fault, amendment.name ? amendment.name->span() : amendment.span,
                                std::move(what), std::move(remedy));
    }

    void apply(const AmendmentIr& amendment) {
        if (amendment.ball) {
            if (*amendment.ball < balls_.size()) return amend_ball(*amendment.ball, amendment);
            return complain(amendment, "amends-nothing",
                            fmt::format("there is no ball {}", *amendment.ball),
                            fmt::format("the level has {}, numbered from 0", balls_.size()));
        }
        if (amendment.edge) {
            if (*amendment.edge < capsules_.size()) return amend_edge(*amendment.edge, amendment);
            return complain(amendment, "amends-nothing",
                            fmt::format("there is no edge {}", *amendment.edge),
                            fmt::format("the level has {}, numbered from 0", capsules_.size()));
        }
        if (const auto ball = symbols_.ball_named(amendment.name->text))
            return amend_ball(*ball, amendment);
        if (const auto edge = symbols_.edge_named(amendment.name->text))
            return amend_edge(*edge, amendment);
        if (symbols_.is_error_name(amendment.name->text)) return;
        const std::vector<std::string> known = symbols_.body_names();
        complain(amendment, "amends-nothing",
                 fmt::format("there is no ball or edge '{}'", amendment.name->text),
                 did_you_mean(amendment.name->text, {known.begin(), known.end()},
                              "of several that share a name, write NAME.2 for the second"));
    }

    void amend_ball(std::size_t ball, const AmendmentIr& amendment) {
        if (!amendment.ends.empty())
            return complain(amendment, "amends-otherwise", "a ball has no ends", "write at=X,Y");
        if (amendment.removes) {
            result_.is_removed.resize(balls_.size(), false);
            result_.is_removed[ball] = true;
            return;
        }
        if (amendment.position) balls_[ball].position = *amendment.position;
        if (amendment.velocity) balls_[ball].velocity = *amendment.velocity;
        if (amendment.spin) {
            result_.spin.resize(balls_.size());
            result_.spin[ball] = amendment.spin;
        }
        if (amendment.roll) {
            result_.roll.resize(balls_.size());
            result_.roll[ball] = amendment.roll;
        }
    }

    void amend_edge(std::size_t edge, const AmendmentIr& amendment) {
        if (capsules_[edge].device >= 0)
            return complain(amendment, "amends-otherwise", "this edge is a part of a pinball table",
                            "move the part");
        if (amendment.removes) {
            is_edge_removed_[edge] = true;
            return;
        }
        if (amendment.position || amendment.velocity || amendment.roll || amendment.spin ||
            amendment.ends.empty())
            return complain(amendment, "amends-otherwise", "an edge moves by its ends",
                            "write both ends, X,Y X,Y, or the one place of a peg");
        capsules_[edge].shape.start = amendment.ends.front();
        capsules_[edge].shape.end = amendment.ends.back();
    }

    std::vector<StartingBall>& balls_;
    SymbolTable& symbols_;
    Context& context_;
    std::vector<CapsuleIr>& capsules_;
    std::vector<bool> is_edge_removed_;
    Amended result_;
};

}  // namespace

Amended amend(std::vector<StartingBall>& balls, SymbolTable& symbols, Context& context) {
    symbols.name_edges();
    if (context.ir.amendments.empty()) return {};
    return Amending(balls, symbols, context).run();
}

}  // namespace carom
