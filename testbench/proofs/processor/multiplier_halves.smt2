; SPDX-License-Identifier: Apache-2.0
; A product is the sum of the four of its factors' halves, each in its place: what multiplier.psl proves of the
; result is said of this sum.
(declare-const first_high Int)
(declare-const first_low Int)
(declare-const second_high Int)
(declare-const second_low Int)
(define-fun whole ((high Int) (low Int)) Int (+ (* 65536 high) low))
(assert (not (= (* (whole first_high first_low) (whole second_high second_low))
                (+ (* 4294967296 (* first_high second_high))
                   (* 65536 (* first_high second_low))
                   (* 65536 (* first_low second_high))
                   (* first_low second_low)))))
(check-sat)
