#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "game/session/session.h"
#include "lab/observe/observer.h"
#include "physics/tick/totals.h"
#include "terminal/canvas/camera.h"
#include "terminal/canvas/canvas.h"
#include "terminal/panels/energy.h"

/// The panels beside or below the world: the level's histogram, the energy over time, and what the
/// level observes.
namespace carom {

class Panels {
  public:
    /// Shows the panels that the scene asks for.
    explicit Panels(const Scene& scene);

    static bool has_histogram(const Scene& scene);
    void toggle_histogram() { shows_histogram_ = !shows_histogram_; }
    /// The speeds of the balls: the histogram of a level that counts nothing. True: it is shown.
    bool toggle_speeds();
    void toggle_energy() { shows_energy_ = !shows_energy_; }
    /// Whether it is, so that the counts of its bins need not be written beside them.
    bool is_histogram_drawn() const { return histogram_area_.rows > 0; }

    /// Takes the room for the panels from `area`; nothing where `is_split`, or where the area is
    /// too small.
    void cut(CellArea& area, const Scene& scene, bool is_split);
    /// Adds a sample of energy and momentum. `drift`: of the energy; none: it is not conserved.
    void sample(std::uint64_t tick, const Totals& sums, std::optional<double> drift);
    void clear() { energy_.clear(); }
    /// `observer`: null where nothing is observed.
    void draw(Canvas& canvas, const Session& session, const Observer* observer,
              const Camera& camera, const Look& look) const;

  private:
    bool shows_histogram_ = false;
    bool shows_energy_ = false;
    CellArea histogram_area_;
    CellArea energy_area_;
    std::vector<Observable> observables_;  ///< one panel each
    std::vector<CellArea> observable_areas_;
    EnergyHistory energy_;
};

}  // namespace carom
