// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

// The passes for the usual numbers of states and measured numbers, known to the compiler: a filter's matrices then stay
// in registers, of which each holds the same element of several filters.

#include <cmath>
#include <limits>

#include "core/simd.hpp"
#include "filtering/kalman_lanes.hpp"

#if defined(__GNUC__) || defined(__clang__)
#define SURVTRACK_UNROLLED _Pragma("GCC unroll 16")
#else
#define SURVTRACK_UNROLLED
#endif

namespace survtrack {
namespace {

using Index = Eigen::Index;

/// Element (i, j) of a symmetric matrix, of which the upper triangle was filled in.
template <int N>
SURVTRACK_SIMD_INLINE constexpr int at(int i, int j) {
  return i <= j ? i * N + j : j * N + i;
}

/// `Upper`: F has nothing below its diagonal, as where each derivative moves the one before.
template <int N, bool Upper>
struct PredictKernel {
  SURVTRACK_SIMD_INLINE void operator()(const KalmanLanes& a, const double* F, const double* Q, double* faults) const {
    const Index stride = a.stride;
    const double *const in_x = a.x, *const in_P = a.P;
    double *const out_x = a.next_x, *const out_P = a.next_P;
    SURVTRACK_SIMD_LOOP for (Index l = 0; l < stride; ++l) {
      double x[N], P[N * N], FP[N * N];
      double sum = 0.0;
      SURVTRACK_UNROLLED for (int i = 0; i < N; ++i) {
        x[i] = in_x[i * stride + l];
        SURVTRACK_UNROLLED for (int j = i; j < N; ++j) P[i * N + j] = in_P[KalmanLanes::upper(N, i, j) * stride + l];
      }
      SURVTRACK_UNROLLED for (int i = 0; i < N; ++i) {
        double moved = 0.0;
        SURVTRACK_UNROLLED for (int k = Upper ? i : 0; k < N; ++k) moved += F[i * N + k] * x[k];
        out_x[i * stride + l] = moved;
        sum += moved;
        SURVTRACK_UNROLLED for (int j = 0; j < N; ++j) {
          double value = 0.0;
          SURVTRACK_UNROLLED for (int k = Upper ? i : 0; k < N; ++k) value += F[i * N + k] * P[at<N>(k, j)];
          FP[i * N + j] = value;
        }
        SURVTRACK_UNROLLED for (int j = 0; j <= i; ++j) {
          double value = Q[j * N + i];
          SURVTRACK_UNROLLED for (int k = Upper ? j : 0; k < N; ++k) value += FP[i * N + k] * F[j * N + k];
          out_P[KalmanLanes::upper(N, j, i) * stride + l] = value;
          sum += value;
        }
      }
      faults[l] = sum - sum;  // 0 unless a number is not finite
    }
  }
};

/// `First`: the first M states are what is measured, H = [I 0].
template <int N, int M, bool First>
struct UpdateKernel {
  SURVTRACK_SIMD_INLINE void operator()(const KalmanLanes& a, const double* H, const double* R, double checked,
                                        double* faults) const {
    constexpr double smallest_share = 16.0 * std::numeric_limits<double>::epsilon();
    const Index stride = a.stride;
    const double *const in_x = a.x, *const in_P = a.P, *const in_z = a.z;
    double *const out_x = a.next_x, *const out_P = a.next_P, *const out_y = a.y, *const out_S = a.S, *const out_nis = a.nis;
    SURVTRACK_SIMD_LOOP for (Index l = 0; l < stride; ++l) {
      double x[N], P[N * N], PH[N * M], K[N * M], S[M * M], y[M], w[M], inverse[M], A[N * N], AP[N * N], KR[N * M];
      SURVTRACK_UNROLLED for (int i = 0; i < N; ++i) {
        x[i] = in_x[i * stride + l];
        SURVTRACK_UNROLLED for (int j = i; j < N; ++j) P[i * N + j] = in_P[KalmanLanes::upper(N, i, j) * stride + l];
      }
      SURVTRACK_UNROLLED for (int c = 0; c < M; ++c) {
        y[c] = in_z[c * stride + l];
        if constexpr (First) y[c] -= x[c];
        SURVTRACK_UNROLLED for (int k = 0; k < (First ? 0 : N); ++k) y[c] -= H[c * N + k] * x[k];
        out_y[c * stride + l] = y[c];
        SURVTRACK_UNROLLED for (int i = 0; i < N; ++i) {
          PH[i * M + c] = First ? P[at<N>(i, c)] : 0.0;
          SURVTRACK_UNROLLED for (int k = 0; k < (First ? 0 : N); ++k) PH[i * M + c] += P[at<N>(i, k)] * H[c * N + k];
          K[i * M + c] = PH[i * M + c];
        }
      }
      const bool given = y[0] == y[0];  // not NaN
      double nis = 0.0, fault = 0.0;
      // S = L D L', below the diagonal L; y through its forward half.
      SURVTRACK_UNROLLED for (int c = 0; c < M; ++c) {
        SURVTRACK_UNROLLED for (int d = 0; d <= c; ++d) {
          double value = R[d * M + c];
          if constexpr (First) value += P[d * N + c];
          SURVTRACK_UNROLLED for (int k = 0; k < (First ? 0 : N); ++k) value += H[d * N + k] * PH[k * M + c];
          S[c * M + d] = value;
          out_S[KalmanLanes::upper(M, d, c) * stride + l] = value;
        }
      }
      SURVTRACK_UNROLLED for (int j = 0; j < M; ++j) {
        double pivot = S[j * M + j];
        SURVTRACK_UNROLLED for (int k = 0; k < j; ++k) pivot -= S[j * M + k] * S[j * M + k] * S[k * M + k];
        const double size = std::abs(pivot), least = smallest_share * std::abs(S[j * M + j]);
        const double share = checked != 0.0 ? pivot : size;
        fault = share > least ? fault : 1.0;
        S[j * M + j] = pivot;
        inverse[j] = 1.0 / pivot;
        SURVTRACK_UNROLLED for (int i = j + 1; i < M; ++i) {
          double value = S[i * M + j];
          SURVTRACK_UNROLLED for (int k = 0; k < j; ++k) value -= S[i * M + k] * S[j * M + k] * S[k * M + k];
          S[i * M + j] = value * inverse[j];
        }
        w[j] = y[j];
        SURVTRACK_UNROLLED for (int k = 0; k < j; ++k) w[j] -= S[j * M + k] * w[k];
        nis += w[j] * w[j] * inverse[j];
      }
      out_nis[l] = nis;
      double sum = 0.0;
      SURVTRACK_UNROLLED for (int i = 0; i < N; ++i) {
        SURVTRACK_UNROLLED for (int c = 1; c < M; ++c) {
          SURVTRACK_UNROLLED for (int k = 0; k < c; ++k) K[i * M + c] -= S[c * M + k] * K[i * M + k];
        }
        double moved = x[i];
        SURVTRACK_UNROLLED for (int c = M - 1; c >= 0; --c) {
          K[i * M + c] *= inverse[c];
          SURVTRACK_UNROLLED for (int k = c + 1; k < M; ++k) K[i * M + c] -= S[k * M + c] * K[i * M + k];
        }
        SURVTRACK_UNROLLED for (int c = 0; c < M; ++c) moved += K[i * M + c] * y[c];
        const double kept = given ? moved : x[i];
        out_x[i * stride + l] = kept;
        sum += kept;
        SURVTRACK_UNROLLED for (int c = 0; c < M; ++c) {
          KR[i * M + c] = 0.0;
          SURVTRACK_UNROLLED for (int d = 0; d < M; ++d) KR[i * M + c] += K[i * M + d] * R[d * M + c];
        }
        SURVTRACK_UNROLLED for (int j = 0; j < N; ++j) {
          A[i * N + j] = i == j ? 1.0 : 0.0;
          if (First && j < M) A[i * N + j] -= K[i * M + j];
          SURVTRACK_UNROLLED for (int c = 0; c < (First ? 0 : M); ++c) A[i * N + j] -= K[i * M + c] * H[c * N + j];
        }
        SURVTRACK_UNROLLED for (int j = 0; j < N; ++j) {
          // Beyond the measured states the columns of I - K H are the identity's.
          AP[i * N + j] = First && i >= M ? P[at<N>(i, j)] : 0.0;
          SURVTRACK_UNROLLED for (int k = 0; k < (First ? M : N); ++k) AP[i * N + j] += A[i * N + k] * P[at<N>(k, j)];
        }
        SURVTRACK_UNROLLED for (int j = 0; j <= i; ++j) {
          double value = First && j >= M ? AP[i * N + j] : 0.0;
          SURVTRACK_UNROLLED for (int k = 0; k < (First ? M : N); ++k) value += AP[i * N + k] * A[j * N + k];
          SURVTRACK_UNROLLED for (int c = 0; c < M; ++c) value += KR[i * M + c] * K[j * M + c];
          const double stays = given ? value : P[j * N + i];
          out_P[KalmanLanes::upper(N, j, i) * stride + l] = stays;
          sum += stays;
        }
      }
      const double wrong = fault != 0.0 ? 1.0 : sum - sum;
      faults[l] = given ? wrong : 0.0;
    }
  }
};

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

template <int N>
bool predict_of(const KalmanLanes& lanes, const RowMajor& F, const RowMajor& Q, double* faults) {
  bool upper = true;
  for (Index i = 0; i < N; ++i) {
    for (Index j = 0; j < i; ++j) upper = upper && F(i, j) == 0.0;
  }
  if (upper) simd::run<PredictKernel<N, true>>(lanes, F.data(), Q.data(), faults);
  else simd::run<PredictKernel<N, false>>(lanes, F.data(), Q.data(), faults);
  return true;
}

template <int N, int M>
bool update_of(const KalmanLanes& lanes, const RowMajor& H, const RowMajor& R, double checked, double* faults) {
  if (H == RowMajor::Identity(M, N)) simd::run<UpdateKernel<N, M, true>>(lanes, H.data(), R.data(), checked, faults);
  else simd::run<UpdateKernel<N, M, false>>(lanes, H.data(), R.data(), checked, faults);
  return true;
}

}  // namespace

bool predict_fixed(const KalmanLanes& lanes, const Eigen::MatrixXd& F, const Eigen::MatrixXd& Q, double* faults) {
  switch (lanes.n) {
    case 2: return predict_of<2>(lanes, F, Q, faults);
    case 4: return predict_of<4>(lanes, F, Q, faults);
    case 6: return predict_of<6>(lanes, F, Q, faults);
    default: return false;
  }
}

bool update_fixed(const KalmanLanes& lanes, const Eigen::MatrixXd& H, const Eigen::MatrixXd& R, bool checked, double* faults) {
  const double check = checked ? 1.0 : 0.0;
  if (lanes.n == 2 && lanes.m == 1) return update_of<2, 1>(lanes, H, R, check, faults);
  if (lanes.n == 4 && lanes.m == 2) return update_of<4, 2>(lanes, H, R, check, faults);
  if (lanes.n == 6 && lanes.m == 2) return update_of<6, 2>(lanes, H, R, check, faults);
  return false;
}

}  // namespace survtrack
