// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// A simulation in a worker.
import { answerCalls } from './answer.js';
import { Session } from './session.js';

answerCalls(Session);
