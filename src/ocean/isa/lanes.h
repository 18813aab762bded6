// Several floats that are computed with at once, and KissFFT over them: one call transforms as many
// columns as there are lanes. Included inside an unnamed namespace by isa/waves.inc only, which
// defines GP_LANES. KissFFT's template stands in there too, over small types of our own in place of
// the standard library's: what is compiled for one instruction set must not have weak symbols, and
// twiddle factors are computed in double.

struct Lanes {
    typedef float Vector __attribute__((vector_size(4 * GP_LANES)));
    Vector v;

    Lanes() = default;
    Lanes(Vector vector) : v(vector) {}
    Lanes(float s) : v(s - Vector{}) {}
    static Lanes load(const float* p) {
        Lanes result;
        __builtin_memcpy(&result, p, sizeof(result));
        return result;
    }
    friend Lanes operator+(Lanes a, Lanes b) { return a.v + b.v; }
    friend Lanes operator-(Lanes a, Lanes b) { return a.v - b.v; }
    friend Lanes operator*(Lanes a, Lanes b) { return a.v * b.v; }
    friend Lanes operator/(Lanes a, Lanes b) { return a.v / b.v; }
    friend Lanes operator-(Lanes a) { return -a.v; }
    float operator[](int i) const { return v[i]; }
};

struct ComplexLanes {
    Lanes re, im;

    ComplexLanes() = default;
    ComplexLanes(Lanes r, Lanes i) : re(r), im(i) {}
    Lanes real() const { return re; }
    Lanes imag() const { return im; }
    void imag(Lanes i) { im = i; }
    friend ComplexLanes operator+(const ComplexLanes& a, const ComplexLanes& b) {
        return {a.re + b.re, a.im + b.im};
    }
    friend ComplexLanes operator-(const ComplexLanes& a, const ComplexLanes& b) {
        return {a.re - b.re, a.im - b.im};
    }
    friend ComplexLanes operator*(const ComplexLanes& a, const ComplexLanes& b) {
        return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
    }
    friend ComplexLanes operator*(const ComplexLanes& a, Lanes s) { return {a.re * s, a.im * s}; }
    ComplexLanes& operator+=(const ComplexLanes& b) { return *this = *this + b; }
    ComplexLanes& operator*=(Lanes s) { return *this = *this * s; }
};

// What KissFFT asks of namespace std.
namespace fft {
namespace std {

using size_t = ::std::size_t;

template <class T>
using complex = ComplexLanes;

template <class T>
class vector {
public:
    using iterator = T*;
    vector() = default;
    vector(const vector&) = delete;
    vector& operator=(const vector&) = delete;
    ~vector() { delete[] items_; }
    void resize(size_t n) {
        T* items = new T[n];
        for (size_t i = 0; i < size_ && i < n; ++i) items[i] = items_[i];
        delete[] items_;
        items_ = items;
        size_ = n;
    }
    void push_back(const T& item) {
        resize(size_ + 1);
        items_[size_ - 1] = item;
    }
    size_t size() const { return size_; }
    T& operator[](size_t i) { return items_[i]; }
    const T& operator[](size_t i) const { return items_[i]; }
    T* begin() { return items_; }
    T* end() { return items_ + size_; }

private:
    T* items_ = nullptr;
    size_t size_ = 0;
};

inline double acos(Lanes minusOne) { return ::std::acos(double(minusOne[0])); }
// Angles here are multiples of 1 / 1024 turn that float has rounded.
inline ComplexLanes exp(const ComplexLanes& angle) {
    const double turn = ::std::round(double(angle.im[0]) / (2.0 * M_PI) * 4096.0) / 4096.0;
    return {float(::std::cos(2.0 * M_PI * turn)), float(::std::sin(2.0 * M_PI * turn))};
}
// Of KissFFT's members that are not used.
inline ComplexLanes conj(const ComplexLanes& z) { return {z.re, -z.im}; }
template <class T>
void swap(T&, T&) = delete;

}  // namespace std

#include <kissfft/kissfft.hh>

}  // namespace fft
