"""The endpoints of this room."""

from fastapi import APIRouter

from app.kit.http import Route

router = APIRouter(prefix="/v1", tags=["sound-lists"], route_class=Route)
