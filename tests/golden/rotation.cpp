// A rotation, which g++ 12 fuses as soon as the machine has FMA, even with -ffp-contract=off. CI
// compiles it with -march and looks whether the options of this build prevent that.

namespace carom::test {

struct Vector {
    double x = 0.0;
    double y = 0.0;
};

Vector rotated(Vector v, double cosine, double sine);

Vector rotated(Vector v, double cosine, double sine) {
    return {cosine * v.x - sine * v.y, sine * v.x + cosine * v.y};
}

}  // namespace carom::test
