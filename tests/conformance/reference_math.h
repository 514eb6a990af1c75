// Float64 vectors and matrices for expectations, written from the formulas of section 2.10.2 and shared by no
// product.
#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "harness.h"

namespace conformance {

// Column-major, as LoadMatrix takes it: element (row, column) is m[column * 4 + row].
struct Mat4 {
  std::array<double, 16> m = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

  double& at(int row, int column) { return m[static_cast<std::size_t>(column * 4 + row)]; }
  double at(int row, int column) const { return m[static_cast<std::size_t>(column * 4 + row)]; }

  friend Mat4 operator*(const Mat4& a, const Mat4& b) {
    Mat4 product;
    for (int row = 0; row < 4; ++row) {
      for (int column = 0; column < 4; ++column) {
        double sum = 0;
        for (int k = 0; k < 4; ++k) sum += a.at(row, k) * b.at(k, column);
        product.at(row, column) = sum;
      }
    }
    return product;
  }
  Vec4 operator*(const Vec4& v) const {
    Vec4 result{};
    for (int row = 0; row < 4; ++row) {
      for (int k = 0; k < 4; ++k)
        result[static_cast<std::size_t>(row)] += at(row, k) * v[static_cast<std::size_t>(k)];
    }
    return result;
  }
};

inline Mat4 translation(double x, double y, double z) {
  Mat4 t;
  t.at(0, 3) = x;
  t.at(1, 3) = y;
  t.at(2, 3) = z;
  return t;
}

inline Mat4 scaling(double x, double y, double z) {
  Mat4 s;
  s.at(0, 0) = x;
  s.at(1, 1) = y;
  s.at(2, 2) = z;
  return s;
}

inline Mat4 rotation(double degrees, double x, double y, double z) {
  const double length = std::sqrt(x * x + y * y + z * z);
  const std::array<double, 3> u = {x / length, y / length, z / length};
  const double angle = degrees * std::numbers::pi / 180, c = std::cos(angle), s = std::sin(angle);
  const double skew[3][3] = {{0, -u[2], u[1]}, {u[2], 0, -u[0]}, {-u[1], u[0], 0}};
  Mat4 r;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      const double outer = u[static_cast<std::size_t>(row)] * u[static_cast<std::size_t>(column)];
      r.at(row, column) = outer + c * ((row == column) - outer) + s * skew[row][column];
    }
  }
  return r;
}

inline Mat4 frustum(double l, double r, double b, double t, double n, double f) {
  Mat4 p;
  p.at(0, 0) = 2 * n / (r - l);
  p.at(1, 1) = 2 * n / (t - b);
  p.at(0, 2) = (r + l) / (r - l);
  p.at(1, 2) = (t + b) / (t - b);
  p.at(2, 2) = -(f + n) / (f - n);
  p.at(2, 3) = -2 * f * n / (f - n);
  p.at(3, 2) = -1;
  p.at(3, 3) = 0;
  return p;
}

inline Mat4 ortho(double l, double r, double b, double t, double n, double f) {
  Mat4 p;
  p.at(0, 0) = 2 / (r - l);
  p.at(1, 1) = 2 / (t - b);
  p.at(2, 2) = -2 / (f - n);
  p.at(0, 3) = -(r + l) / (r - l);
  p.at(1, 3) = -(t + b) / (t - b);
  p.at(2, 3) = -(f + n) / (f - n);
  return p;
}

inline double dot(const Vec3& a, const Vec3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline double length(const Vec3& v) {
  return std::sqrt(dot(v, v));
}
inline Vec3 scaled(const Vec3& v, double by) {
  return {v[0] * by, v[1] * by, v[2] * by};
}
inline Vec3 added(const Vec3& a, const Vec3& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Vec3 normalised(const Vec3& v) {
  const double l = length(v);
  return l > 0 ? scaled(v, 1 / l) : Vec3{0, 0, 0};
}

// (nx ny nz) * Mu^-1 of section 2.10.3, by cofactors.
inline Vec3 transformedNormal(const Mat4& m, const Vec3& n) {
  const auto e = [&](int r, int c) { return m.at(r % 3, c % 3); };
  double inverse[3][3], determinant = 0;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c)
      inverse[c][r] = e(r + 1, c + 1) * e(r + 2, c + 2) - e(r + 1, c + 2) * e(r + 2, c + 1);
  }
  for (int c = 0; c < 3; ++c) determinant += e(0, c) * inverse[c][0];
  Vec3 result{};
  for (int c = 0; c < 3; ++c) {
    for (int r = 0; r < 3; ++r) {
      result[static_cast<std::size_t>(c)] += n[static_cast<std::size_t>(r)] * inverse[r][c] / determinant;
    }
  }
  return result;
}

// 1 / |third row of M^-1|, the factor of RESCALE_NORMAL (2.10.3).
inline double rescaleFactor(const Mat4& m) {
  return 1 / length(transformedNormal(m, {0, 0, 1}));
}

}  // namespace conformance
