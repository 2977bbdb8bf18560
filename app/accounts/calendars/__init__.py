"""Working times of studios: their time zone and holidays."""
