import { useEffect, useRef, useSyncExternalStore } from 'react'

import classes from './Drawing.module.css'
import type { Surface } from './draw'

function subscribeToScheme(listener: () => void): () => void {
  const observer = new MutationObserver(listener)
  observer.observe(document.documentElement, { attributes: true, attributeFilter: ['data-mantine-color-scheme'] })
  return () => observer.disconnect()
}

const seenScheme = () => document.documentElement.getAttribute('data-mantine-color-scheme') ?? 'light'

interface DrawingProps {
  /** Keep it the same function while nothing changes: every new one draws again. */
  draw: (surface: Surface) => void
  className?: string
}

/** A canvas that fills its place, sharp on every screen, and draws again when its size or the colours change. */
export function Drawing({ draw, className }: DrawingProps) {
  const canvasRef = useRef<HTMLCanvasElement>(null)
  const scheme = useSyncExternalStore(subscribeToScheme, seenScheme)

  useEffect(() => {
    const canvas = canvasRef.current
    if (canvas === null) return
    const paint = () => {
      const scale = window.devicePixelRatio || 1
      const box = canvas.getBoundingClientRect()
      const width = Math.round(box.width * scale)
      const height = Math.round(box.height * scale)
      const context = canvas.getContext('2d')
      if (context === null || width === 0 || height === 0) return
      canvas.width = width
      canvas.height = height
      const style = getComputedStyle(canvas)
      const colour = (token: string) => style.getPropertyValue(`--sl-${token}`).trim()
      draw({ context, width, height, scale, colour })
    }
    paint()
    const observer = new ResizeObserver(paint)
    observer.observe(canvas)
    return () => observer.disconnect()
  }, [draw, scheme])

  return <canvas ref={canvasRef} className={[classes.canvas, className].filter(Boolean).join(' ')} aria-hidden="true" />
}
