"""Learned models that need numpy alone: boosted trees and small neural nets."""
