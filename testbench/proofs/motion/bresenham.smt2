; SPDX-License-Identifier: Apache-2.0
; From the sum that axis_stepper.psl proves to the number of steps. Each question asks for a counterexample to
; its claim: there must be none.

(declare-const line_ticks Int)
(declare-const steps Int)
(declare-const ticks_made Int)
(declare-const pulses_made Int)
(declare-const start Int)
(declare-const balance Int)
(assert (and (>= line_ticks 1) (< line_ticks 2147483648)))
(assert (and (>= steps 0) (<= steps line_ticks)))
(assert (and (>= ticks_made 0) (>= pulses_made 0)))
(assert (and (>= start 0) (< start line_ticks)))
(define-fun sum ((ticks Int) (pulses Int)) Int (- (+ start (* steps ticks)) (* line_ticks pulses)))

; The balance that is added up is this sum: at the start of a line, ...
(push)
(assert (not (= start (sum 0 0))))
(check-sat)
(pop)
; ... at a tick without a step, ...
(push)
(assert (= balance (sum ticks_made pulses_made)))
(assert (not (= (+ balance steps) (sum (+ ticks_made 1) pulses_made))))
(check-sat)
(pop)
; ... and at a tick with one.
(push)
(assert (= balance (sum ticks_made pulses_made)))
(assert (not (= (- (+ balance steps) line_ticks) (sum (+ ticks_made 1) (+ pulses_made 1)))))
(check-sat)
(pop)

; After all ticks of the line exactly its steps are made.
(push)
(assert (= balance (sum ticks_made pulses_made)))
(assert (and (>= balance 0) (< balance line_ticks)))
(assert (= ticks_made line_ticks))
(assert (or (>= pulses_made (+ steps 1)) (<= pulses_made (- steps 1))))
(check-sat)
(pop)
