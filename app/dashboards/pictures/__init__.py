"""Pictures of people, as others see them."""
