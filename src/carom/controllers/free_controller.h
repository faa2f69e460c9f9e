#pragma once

#include "carom/context/controller.h"

/// Free play: the mouse drags balls and edges and pulls the cue; keys add, remove and change.
namespace carom {

class FreeController : public Controller {
  public:
    PlayKind kind() const override { return PlayKind::free; }
    void perform(PlayContext& play, const Action& action) override;
    void press(PlayContext& play, const InputEvent& event) override;
    void release(PlayContext& play, const InputEvent& event) override;
    bool drags_anything() const override { return true; }

  protected:
    /// Offers a press with an empty tool to the derived controller first. True: it was consumed.
    virtual bool take_press(PlayContext&, const InputEvent&) { return false; }
    /// Offers the release of the tool's button to the derived controller first. True: it was
    /// consumed.
    virtual bool take_release(PlayContext&) { return false; }
};

/// The numbers of the mouse buttons in events.
inline constexpr std::uint8_t left_button = 1;
inline constexpr std::uint8_t middle_button = 2;
inline constexpr std::uint8_t right_button = 3;

}  // namespace carom
