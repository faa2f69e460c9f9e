#include "physics/laws/cloth.h"

#include "geometry/double_double.h"

namespace carom {

template <typename Real>
ClothPhase<Real> cloth_phase(const Cloth& cloth, double inertia, const Vector<Real>& velocity,
                             const Vector<Real>& roll) {
    ClothPhase<Real> phase;
    const Vector<Real> slip = velocity - roll;
    const Real slipping = length(slip);
    const Real speed = length(velocity);
    const Real rounding = Real(16.0 * precision<Real>) * (speed + length(roll));
    if (slipping > rounding) {
        const Real force = Real(cloth.slide * cloth.gravity);
        const Vector<Real> along = slip / slipping;
        phase.motion = ClothMotion::sliding;
        phase.acceleration = -along * force;
        phase.roll_acceleration = along * (force / Real(inertia));
        phase.lasts = slipping / (force * (Real(1.0) + Real(1.0) / Real(inertia)));
        return phase;
    }
    if (!(speed > Real{})) return phase;
    phase.motion = ClothMotion::rolling;
    const Real force = Real(cloth.roll * cloth.gravity);
    if (!(force > Real{})) return phase;
    phase.acceleration = velocity * (-force / speed);
    phase.roll_acceleration = phase.acceleration;
    phase.lasts = speed / force;
    return phase;
}

template <typename Real>
Real cloth_spin_after(const Cloth& cloth, const Real& spin, const Real& duration) {
    const Real lost = Real(cloth.spin) * duration;
    if (!(lost < absolute(spin))) return Real{};
    return spin < Real{} ? spin + lost : spin - lost;
}

template <typename Real>
ClothState<Real> cloth_state_after(const Cloth& cloth, double inertia, ClothState<Real> state,
                                   Real duration) {
    state.spin = cloth_spin_after(cloth, state.spin, duration);
    while (duration > Real{}) {
        const auto phase = cloth_phase(cloth, inertia, state.velocity, state.roll);
        if (phase.motion == ClothMotion::still) {
            state.velocity = state.roll = {};
            return state;
        }
        const bool ends = phase.lasts && !(duration < *phase.lasts);
        const Real time = ends ? *phase.lasts : duration;
        state.position += (state.velocity + phase.acceleration * (Real(0.5) * time)) * time;
        state.velocity += phase.acceleration * time;
        state.roll += phase.roll_acceleration * time;
        // At the end of a phase slip or velocity is exactly 0; computing it would leave rounding.
        if (ends && phase.motion == ClothMotion::rolling) state.velocity = {};
        if (phase.motion == ClothMotion::rolling || ends) state.roll = state.velocity;
        duration = duration - time;
    }
    return state;
}

template ClothPhase<double> cloth_phase(const Cloth&, double, const Vector<double>&,
                                        const Vector<double>&);
template ClothPhase<DoubleDouble> cloth_phase(const Cloth&, double, const Vector<DoubleDouble>&,
                                              const Vector<DoubleDouble>&);
template double cloth_spin_after(const Cloth&, const double&, const double&);
template DoubleDouble cloth_spin_after(const Cloth&, const DoubleDouble&, const DoubleDouble&);
template ClothState<double> cloth_state_after(const Cloth&, double, ClothState<double>, double);
template ClothState<DoubleDouble> cloth_state_after(const Cloth&, double, ClothState<DoubleDouble>,
                                                    DoubleDouble);

}  // namespace carom
