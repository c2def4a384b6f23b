// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <vector>

namespace survtrack {

// One row of the belief matrix (Narayana 2007, 8.3): the probabilities that a track is each of v blobs, and, in the
// last entry, that it is "lost". Each row sums to 1 and costs O(v).

/// What one blob says of one track: p(observation | assigned) / p(observation | not assigned) for colour, position
/// and size, 1 for what was not observed; and the falling velocity factor, 1 for none.
struct Evidence {
  double color = 1.0;
  double position = 1.0;
  double size = 1.0;
  double velocity = 1.0;
};

/// The order of the blobs does not matter: the entries are proportional to the products of a blob's evidence, and 1
/// for "lost". The same as Bayes' rule blob by blob, with the velocity factor applied to the odds.
/// `row` gets evidence.size() + 1 entries. Ratios are finite and at least 0.
void order_free_beliefs(const std::vector<Evidence>& evidence, double* row);

/// As published: blob after blob the colour, the position (and the size) update the entry by eq. 8.16 and 8.17, then
/// it is multiplied by the velocity factor, and after each step the others are rescaled by eq. 8.19. The entry never
/// exceeds 1 - 1e-9. The order of the blobs matters as soon as there are velocity factors.
/// `row` as above; `scales` is memory to reuse.
void published_beliefs(const std::vector<Evidence>& evidence, double* row, std::vector<double>& scales);

}  // namespace survtrack
