#include "bits/recording_writer.h"

#include <algorithm>
#include <charconv>

#include "bits/level_draft.h"

namespace carom::bits {
namespace {

class CommandWriter {
  public:
    CommandWriter(Random& random, const Level& level) : random_(random), level_(level) {}

    std::vector<TimedLine> write() {
        for (int i = random_.integer(1, 5); i > 0; --i)
            gesture(random_.integer(0, level_.ticks - 2));
        std::ranges::stable_sort(lines_, {}, &TimedLine::tick);
        return lines_;
    }

  private:
    void gesture(int tick) {
        if (level_.has_buttons && random_.chance(0.5)) return button(tick);
        const double r = level_.radius;
        switch (random_.integer(0, 11)) {
            case 0:
            case 1:
                return hold("ball " + ball(), tick, 1);
            case 2:
            case 3:
            case 4:
                return hold("edge " + edge(), tick, 2);
            case 5:
                return add(tick, Line() << "strike " << ball() << ' ' << velocity() << english());
            case 6:
                return add(tick, "gravity " + (random_.chance(0.3) ? "off" : pull()));
            case 7:
                return add(tick, "solver " + write_solver(random_, level_.has_cloth));
            case 8:
                return add(tick,
                           Line() << "place-edge " << edge() << ' ' << place() << ' ' << place());
            case 9:
                return add(tick,
                           "remove-" + (random_.chance(0.5) ? "ball " + ball() : "edge " + edge()));
            case 10:
                return add(tick, Line() << "add-ball 0 " << place() << ' ' << velocity()
                                        << " r=" << r * random_.decades(-0.5, 0.2));
            default:
                if (random_.chance(0.5))
                    return add(tick, Line() << "place-ball " << ball() << ' ' << place());
                return add(tick, Line() << "add-edge 0 " << place() << ' ' << place() << ' '
                                        << r * random_.decades(-2.0, 0.0) << " both");
        }
    }

    // A drag: grabs an object, moves it for some ticks, and usually releases it.
    void hold(const std::string& what, int tick, int points) {
        const int last = std::min(level_.ticks - 1, tick + random_.integer(1, 40));
        double x[2] = {}, y[2] = {};
        for (int i = 0; i < points; ++i) {
            x[i] = random_.between(0.1, 0.9) * level_.width;
            y[i] = random_.between(0.1, 0.9) * level_.height;
        }
        const double dx = level_.radius * random_.between(-0.5, 0.5),
                     dy = level_.radius * random_.between(-0.5, 0.5);
        for (int now = tick; now < last; ++now) {
            std::string command = "hold-" + what;
            for (int i = 0; i < points; ++i) {
                command += ' ' + text_of(x[i]) + ',' + text_of(y[i]);
                x[i] += dx;
                y[i] += dy;
            }
            if (now == tick || random_.chance(0.8)) add(now, command);
        }
        if (random_.chance(0.8)) add(last, "drop-" + what);
    }

    void button(int tick) {
        constexpr const char* buttons[] = {"left", "right", "nudge-left", "nudge-up"};
        if (random_.chance(0.2)) {
            add(tick, "pull " + text_of(random_.between(0.0, 1.0)));
            return add(std::min(level_.ticks - 1, tick + 3),
                       "launch " + text_of(random_.between(0.0, 1.0)));
        }
        const std::string name = random_.one_of(buttons);
        add(tick, "press " + name);
        add(std::min(level_.ticks - 1, tick + random_.integer(1, 30)), "release " + name);
    }

    std::string english() {
        if (!random_.chance(0.4)) return {};
        return (Line() << " side=" << random_.between(-0.4, 0.4)
                       << " follow=" << random_.between(-0.4, 0.4))
            .text();
    }
    std::string ball() { return std::to_string(random_.integer(0, std::max(0, level_.balls - 1))); }
    std::string edge() { return std::to_string(random_.integer(0, std::max(0, level_.edges - 1))); }
    Point place() {
        const double x = random_.between(0.1, 0.9) * level_.width;
        return {x, random_.between(0.1, 0.9) * level_.height};
    }
    Point velocity() {
        const double speed = level_.radius * random_.decades(0.5, 2.0) / level_.time;
        const double x = speed * random_.between(-1.0, 1.0);
        return {x, speed * random_.between(-1.0, 1.0)};
    }
    std::string pull() {
        const double g = level_.radius * random_.decades(0.0, 2.3) / (level_.time * level_.time);
        return text_of(Point{g * random_.between(-1.0, 1.0), -g});
    }
    void add(int tick, std::string command) { lines_.push_back({tick, std::move(command)}); }
    void add(int tick, const Line& command) { add(tick, command.text()); }

    Random& random_;
    const Level& level_;
    std::vector<TimedLine> lines_;
};

std::string barred(std::string_view text) {
    std::string barred = "|";
    for (const char c : text) {
        barred += c;
        if (c == '\n') barred += '|';
    }
    return barred + '\n';
}

}  // namespace

std::vector<TimedLine> write_commands(Random& random, const Level& level) {
    return CommandWriter(random, level).write();
}

std::uint64_t level_hash(std::string_view text) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    const auto add = [&](unsigned char byte) { hash = (hash ^ byte) * 0x100000001b3u; };
    for (const char c : text)
        add(static_cast<unsigned char>(c));
    for (std::size_t length = text.size(), i = 0; i < 8; ++i, length >>= 8)
        add(static_cast<unsigned char>(length & 0xffu));
    return hash;
}

std::string write_solver(Random& random, bool has_cloth) {
    constexpr const char* all[] = {"event", "event",   "contact", "contact",
                                   "swept", "substep", "discrete"};
    std::string name = random.one_of(all);
    if (has_cloth && name == "contact") name = "event";
    return (Line() << name << " updates=" << random.integer(1, 4)
                   << " steps=" << random.integer(1, 8) << " substeps=" << random.integer(1, 4))
        .text();
}

std::string write_recording(const Level& level, const std::string& solver,
                            const std::vector<TimedLine>& commands) {
    char hash[17] = {};
    std::to_chars(hash, hash + 16, level_hash(level.text), 16);
    std::string text = "carom replay 2\nprogram 0.1.0\nlevel fuzzed.level\nfile 0\n" +
                       barred(level.text) + "hash " +
                       std::string(16 - std::string_view(hash).size(), '0') + hash + "\nsolver " +
                       solver + "\nrate " + text_of(level.rate) + "\nseed 5\n";
    for (const TimedLine& line : commands)
        text += "at " + std::to_string(line.tick) + ' ' + line.command + '\n';
    const std::string end = std::to_string(level.ticks);
    return text + "mark " + end + " 0000000000000000\nend " + end + '\n';
}

}  // namespace carom::bits
