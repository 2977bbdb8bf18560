"""Placeholders for cues that have no take yet: to spec, under the right names, marked so that none ships by mistake."""
