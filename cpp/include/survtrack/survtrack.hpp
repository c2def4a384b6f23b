// SPDX-FileCopyrightText: 2026 The survtrack developers
// SPDX-License-Identifier: Apache-2.0

#pragma once

// The whole library: #include <survtrack/survtrack.hpp>
#include "survtrack/association/assign.hpp"
#include "survtrack/association/belief_matrix.hpp"
#include "survtrack/association/costs.hpp"
#include "survtrack/association/density.hpp"
#include "survtrack/association/velocity_factor.hpp"
#include "survtrack/blobs/blob_extractor.hpp"
#include "survtrack/core/errors.hpp"
#include "survtrack/core/version.hpp"
#include "survtrack/filtering/filter_bank.hpp"
#include "survtrack/filtering/kalman_bank.hpp"
#include "survtrack/filtering/motion_model.hpp"
#include "survtrack/offline/link.hpp"
#include "survtrack/offline/patterns.hpp"
#include "survtrack/pipeline/config.hpp"
#include "survtrack/pipeline/detector.hpp"
#include "survtrack/pipeline/pipeline.hpp"
#include "survtrack/pipeline/tracker.hpp"
#include "survtrack/segmentation/cleanup.hpp"
#include "survtrack/segmentation/horn_schunck.hpp"
#include "survtrack/segmentation/segmenter.hpp"
#include "survtrack/segmentation/tiled_morphology.hpp"
