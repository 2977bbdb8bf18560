import { clock, day } from '@/ui/format'

/** "Today, 14:05": a moment as the page of adoptions says it. */
export const at = (moment: string): string => `${day(moment)}, ${clock(moment)}`
