; SPDX-License-Identifier: Apache-2.0
; If `multiple` is quotient * divisor, then it still is after one pair of bits more: 4 * multiple + pair * divisor is
; (4 * quotient + pair) * divisor. So what divider.psl adds up is the product, and its last line the division theorem.
(declare-const quotient Int)
(declare-const divisor Int)
(declare-const pair Int)
(declare-const multiple Int)
(assert (= multiple (* quotient divisor)))
(push)
(assert (not (= (+ (* 4 multiple) (* pair divisor)) (* (+ (* 4 quotient) pair) divisor))))
(check-sat)
(pop)
; At the start both are zero.
(push)
(assert (and (= quotient 0) (not (= multiple 0))))
(check-sat)
(pop)
