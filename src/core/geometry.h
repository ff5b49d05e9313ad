#pragma once

#include <cmath>

namespace overfly {

// Points, vectors, rotations and rigid transforms, tagged with the frame they live in (geo/frames.h). Mixing frames
// does not compile: transforms are named target first and cancel, `a_from_b * b_from_c` is `a_from_c`.

template <class Frame>
struct Vector {
    double x = 0.0, y = 0.0, z = 0.0;

    friend constexpr Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend constexpr Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend constexpr Vector operator-(Vector a) { return {-a.x, -a.y, -a.z}; }
    friend constexpr Vector operator*(double s, Vector a) { return {s * a.x, s * a.y, s * a.z}; }
    friend constexpr Vector operator/(Vector a, double s) { return {a.x / s, a.y / s, a.z / s}; }
    friend constexpr bool operator==(Vector, Vector) = default;
};

template <class Frame>
struct Point {
    double x = 0.0, y = 0.0, z = 0.0;

    friend constexpr Vector<Frame> operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend constexpr Point operator+(Point a, Vector<Frame> v) { return {a.x + v.x, a.y + v.y, a.z + v.z}; }
    friend constexpr Point operator-(Point a, Vector<Frame> v) { return {a.x - v.x, a.y - v.y, a.z - v.z}; }
    friend constexpr bool operator==(Point, Point) = default;
};

template <class F>
[[nodiscard]] constexpr double dot(Vector<F> a, Vector<F> b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class F>
[[nodiscard]] constexpr Vector<F> cross(Vector<F> a, Vector<F> b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class F>
[[nodiscard]] double length(Vector<F> a) {
    return std::sqrt(dot(a, a));
}

template <class F>
[[nodiscard]] double distance(Point<F> a, Point<F> b) {
    return length(a - b);
}

// REQUIRES: a is not the zero vector.
template <class F>
[[nodiscard]] Vector<F> normalized(Vector<F> a) {
    return a / length(a);
}

// A rotation, held as the images of From's axes: columns, each a unit vector in To.
template <class To, class From>
struct Rotation {
    Vector<To> x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};

    friend constexpr Vector<To> operator*(const Rotation& r, Vector<From> v) {
        return v.x * r.x + v.y * r.y + v.z * r.z;
    }
    friend constexpr bool operator==(const Rotation&, const Rotation&) = default;
};

template <class To, class From>
[[nodiscard]] constexpr Rotation<From, To> inverse(const Rotation<To, From>& r) {
    return {{r.x.x, r.y.x, r.z.x}, {r.x.y, r.y.y, r.z.y}, {r.x.z, r.y.z, r.z.z}};
}

template <class A, class B, class C>
[[nodiscard]] constexpr Rotation<A, C> operator*(const Rotation<A, B>& a_from_b, const Rotation<B, C>& b_from_c) {
    return {a_from_b * b_from_c.x, a_from_b * b_from_c.y, a_from_b * b_from_c.z};
}

// A rigid motion: x -> rotation * x + translation.
template <class To, class From>
struct Transform {
    Rotation<To, From> rotation;
    Vector<To> translation;

    constexpr Point<To> operator*(Point<From> p) const {
        const Vector<To> v = rotation * Vector<From>{p.x, p.y, p.z} + translation;
        return {v.x, v.y, v.z};
    }
    constexpr Vector<To> operator*(Vector<From> v) const { return rotation * v; }
    friend constexpr bool operator==(const Transform&, const Transform&) = default;
};

template <class To, class From>
[[nodiscard]] constexpr Transform<From, To> inverse(const Transform<To, From>& t) {
    const Rotation<From, To> r = inverse(t.rotation);
    return {r, -(r * t.translation)};
}

template <class A, class B, class C>
[[nodiscard]] constexpr Transform<A, C> operator*(const Transform<A, B>& a_from_b, const Transform<B, C>& b_from_c) {
    return {a_from_b.rotation * b_from_c.rotation, a_from_b.rotation * b_from_c.translation + a_from_b.translation};
}

}  // namespace overfly
