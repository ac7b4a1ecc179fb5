# SPDX-License-Identifier: Apache-2.0
# Clocks of the DE2-70; the chip's 50 MHz follow from the first through the phase-locked loop.
create_clock -name clock_50mhz -period 20.000 [get_ports {clock_50mhz}]
# 28.63636 MHz by the board's sample designs; its manual has not been compared, so this is 28.9.
create_clock -name clock_28mhz -period 34.600 [get_ports {clock_28mhz}]
derive_pll_clocks
derive_clock_uncertainty
# The clock watch has its own oscillator, and synchronizes what comes from the chip's clock.
set_clock_groups -asynchronous -group [get_clocks {clock_28mhz}]
