"""When studios work: their time zone and holidays."""
