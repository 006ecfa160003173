// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// The worker in which a simulation runs.
import { answerCalls } from '../package/answer.js';
import { PlaygroundSession } from './session.js';

answerCalls(PlaygroundSession);
