#include "predicates/insphere_vectorised.h"

#include "base/assert.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace mesher {

#if defined(__x86_64__)

bool canVectoriseInsphere() { return __builtin_cpu_supports("avx2") != 0; }

[[gnu::target("avx2")]] InsphereVectorEstimate insphereEstimateVectorised(const double* a, const double* b,
                                                                          const double* c, const double* d,
                                                                          const double* e)
{
    const __m256d origin = _mm256_load_pd(e);
    const __m256d rowA = _mm256_sub_pd(_mm256_load_pd(a), origin);
    const __m256d rowB = _mm256_sub_pd(_mm256_load_pd(b), origin);
    const __m256d rowC = _mm256_sub_pd(_mm256_load_pd(c), origin);
    const __m256d rowD = _mm256_sub_pd(_mm256_load_pd(d), origin);
    // Transpose: lane i of x, y, z belongs to a, b, c, d.
    const __m256d xzAB = _mm256_unpacklo_pd(rowA, rowB);
    const __m256d yAB = _mm256_unpackhi_pd(rowA, rowB);
    const __m256d xzCD = _mm256_unpacklo_pd(rowC, rowD);
    const __m256d yCD = _mm256_unpackhi_pd(rowC, rowD);
    const __m256d x = _mm256_permute2f128_pd(xzAB, xzCD, 0x20);
    const __m256d y = _mm256_permute2f128_pd(yAB, yCD, 0x20);
    const __m256d z = _mm256_permute2f128_pd(xzAB, xzCD, 0x31);
    const __m256d lift =
        _mm256_add_pd(_mm256_add_pd(_mm256_mul_pd(x, x), _mm256_mul_pd(y, y)), _mm256_mul_pd(z, z));
    // Minors of neighbours (ab, bc, cd, da) and of opposites (ac, bd, ca, db).
    constexpr int kNext = 0x39;
    const __m256d xNext = _mm256_permute4x64_pd(x, kNext);
    const __m256d yNext = _mm256_permute4x64_pd(y, kNext);
    const __m256d zNext = _mm256_permute4x64_pd(z, kNext);
    const __m256d liftNext = _mm256_permute4x64_pd(lift, kNext);
    const __m256d neighboursXy = _mm256_sub_pd(_mm256_mul_pd(x, yNext), _mm256_mul_pd(y, xNext));
    const __m256d neighboursZl = _mm256_sub_pd(_mm256_mul_pd(z, liftNext), _mm256_mul_pd(lift, zNext));
    const __m128d xLow = _mm256_castpd256_pd128(x);
    const __m128d yLow = _mm256_castpd256_pd128(y);
    const __m128d zLow = _mm256_castpd256_pd128(z);
    const __m128d liftLow = _mm256_castpd256_pd128(lift);
    const __m128d xHigh = _mm256_extractf128_pd(x, 1);
    const __m128d yHigh = _mm256_extractf128_pd(y, 1);
    const __m128d zHigh = _mm256_extractf128_pd(z, 1);
    const __m128d liftHigh = _mm256_extractf128_pd(lift, 1);
    const __m128d oppositesXy = _mm_sub_pd(_mm_mul_pd(xLow, yHigh), _mm_mul_pd(yLow, xHigh));
    const __m128d oppositesZl = _mm_sub_pd(_mm_mul_pd(zLow, liftHigh), _mm_mul_pd(liftLow, zHigh));
    // ab·cd', bc·da', cd·ab', da·bc' with alternating signs, and ac·bd', bd·ac'.
    constexpr int kOpposite = 0x4E;
    const __m256d products = _mm256_mul_pd(neighboursXy, _mm256_permute4x64_pd(neighboursZl, kOpposite));
    const __m128d pairs = _mm_add_pd(_mm256_castpd256_pd128(products), _mm256_extractf128_pd(products, 1));
    const __m128d opposites = _mm_mul_pd(oppositesXy, _mm_shuffle_pd(oppositesZl, oppositesZl, 1));
    const double neighbourSum = _mm_cvtsd_f64(pairs) - _mm_cvtsd_f64(_mm_unpackhi_pd(pairs, pairs));
    const double oppositeSum =
        _mm_cvtsd_f64(opposites) + _mm_cvtsd_f64(_mm_unpackhi_pd(opposites, opposites));
    const __m128d largerLifts = _mm_max_pd(liftLow, liftHigh);
    const __m128d largestLift = _mm_max_sd(largerLifts, _mm_unpackhi_pd(largerLifts, largerLifts));
    return {oppositeSum - neighbourSum, _mm_cvtsd_f64(largestLift)};
}

#else

bool canVectoriseInsphere() { return false; }

InsphereVectorEstimate insphereEstimateVectorised(const double*, const double*, const double*, const double*,
                                                  const double*)
{
    MESHER_PRECONDITION(false);
    return {0.0, 0.0};
}

#endif

}  // namespace mesher
