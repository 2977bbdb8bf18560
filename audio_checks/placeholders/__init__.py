"""Stand-ins for cues that have no take yet: to spec, under the right names, and marked so that none ships unnoticed."""
