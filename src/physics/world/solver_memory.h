#pragma once

#include <cstddef>
#include <memory>
#include <type_traits>
#include <typeinfo>
#include <utility>

#include "physics/world/hash.h"
#include "physics/world/model.h"

/// What a solver leaves in the world for its next tick, beyond the bodies. The world carries it, so
/// that a copy of the world continues with the same bits, but does not know what is in it: each
/// solver that remembers anything has a type of its own, in its room (contact/contact_memory.h,
/// event/motion/event_memory.h).
namespace carom {

/// Names a type of memory: the address of a variable that stands for it.
using MemoryType = const void*;

/// Base of all types of memory. A type derives from MemoryOf, which does what all do alike.
class RetainedMemory {
  public:
    virtual ~RetainedMemory() = default;

    virtual std::unique_ptr<RetainedMemory> clone() const = 0;
    /// Becomes a copy of `other` without new memory where its lists have room. Returns false, and
    /// changes nothing, if `other` is of another type.
    virtual bool assign(const RetainedMemory& other) = 0;
    /// Returns to the state of a new object, but keeps the allocated memory of its lists.
    virtual void clear() = 0;
    /// The part of it that is of this type; null if none is.
    virtual const void* part(MemoryType type) const = 0;
    /// Adds the memory to a hash, as fingerprints of this version do (fingerprint.h).
    virtual void add_to(Hash& hash, const Model& model, int version) const = 0;
    /// Bytes of memory that a copy occupies.
    virtual std::size_t bytes() const = 0;
    /// The next tick starts from where the balls are, as if another solver had made the last one:
    /// drops what assumes that the same bodies collide as before.
    virtual void forget_trajectories() {}
};

/// Copies, clears and names a `Memory`, which derives from MemoryOf<Memory>, or from
/// MemoryOf<Memory, Extended> if it also holds what the type `Extended` does.
template <typename Memory, typename Extended = RetainedMemory>
class MemoryOf : public Extended {
  public:
    /// Its address is the MemoryType.
    static constexpr char type_name{};

    std::unique_ptr<RetainedMemory> clone() const override {
        return std::make_unique<Memory>(memory());
    }
    bool assign(const RetainedMemory& other) override {
        if (typeid(other) != typeid(Memory)) return false;
        memory() = static_cast<const Memory&>(other);
        return true;
    }
    void clear() override {
        static const Memory nothing;
        memory() = nothing;
    }
    const void* part(MemoryType type) const override {
        if (type == &type_name) return &memory();
        if constexpr (std::is_same_v<Extended, RetainedMemory>)
            return nullptr;
        else
            return Extended::part(type);
    }

  private:
    Memory& memory() { return static_cast<Memory&>(*this); }
    const Memory& memory() const { return static_cast<const Memory&>(*this); }
};

/// A slot for the memory of one solver. A value: copying it copies what is in it. An empty slot and
/// one with a memory that remembers nothing are alike in everything but the room that they hold: so
/// a world that goes back to its start again and again allocates only once.
class SolverMemory {
  public:
    SolverMemory() = default;
    SolverMemory(const SolverMemory& other) : held_(other.held_ ? other.held_->clone() : nullptr) {}
    SolverMemory(SolverMemory&&) noexcept = default;
    SolverMemory& operator=(const SolverMemory& other);
    SolverMemory& operator=(SolverMemory&&) noexcept = default;
    ~SolverMemory() = default;

    bool is_empty() const { return held_ == nullptr; }
    void clear() { held_.reset(); }

    /// What a solver left, or null if the slot holds no memory of this type.
    template <typename Memory>
    const Memory* find() const {
        return held_ ? static_cast<const Memory*>(held_->part(&Memory::type_name)) : nullptr;
    }
    /// The memory of this type, to be written. What the slot held of another type is dropped.
    template <typename Memory>
    Memory& use() {
        if (const Memory* const found = find<Memory>()) return const_cast<Memory&>(*found);
        return replace(Memory{});
    }
    template <typename Memory>
    Memory& replace(Memory memory) {
        auto made = std::make_unique<Memory>(std::move(memory));
        Memory& held = *made;
        held_ = std::move(made);
        return held;
    }

    void add_to(Hash& hash, const Model& model, int version) const;
    std::size_t bytes() const { return held_ ? held_->bytes() : 0; }
    void forget_trajectories() {
        if (held_) held_->forget_trajectories();
    }

  private:
    std::unique_ptr<RetainedMemory> held_;
};

}  // namespace carom
